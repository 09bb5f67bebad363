// When what if is begun beside the answers: once for each run and place.

export interface Situation {
  /// Whether it begins by itself.
  isOn: boolean;
  /// What is asked of the shown run, by name; null: nothing that has an answer.
  question: string | null;
  /// Whether a run is under way, which needs the processor.
  isComputing: boolean;
  /// Whether the page knows the last job of the shown run.
  isKnown: boolean;
  /// The question of the last job, if it is of the shown run.
  last: string | null;
  /// The question for which the page has begun one.
  begun: string | null;
}

/// A job that was begun, found or stopped for this question is not begun again; another question or another run is.
export const shouldBegin = ({ isOn, question, isComputing, isKnown, last, begun }: Situation): boolean =>
  isOn && question !== null && !isComputing && isKnown && last !== question && begun !== question;
