// The envelope over a ground section, from the shown run.

import { useMemo } from 'preact/hooks';
import { asking } from '../api/line';
import { useRemote } from '../ui/remote';
import { displayOf, unitSystem } from '../state/displayUnits';
import { hasResults, shown } from '../runs/runs';
import { corridorWidth, sectionEnvelope } from './corridorSettings';
import { sectionLine } from './sectionLine';
import { envelopeChoices, envelopeOf, stationsAlong } from './stations';

const stationCount = 80;

/// The maximum and a percentile at stations across the corridor, over all stored rocks of the run.
export function useEnvelope() {
  const [line, run, wanted, width] = [sectionLine.value, shown.value, sectionEnvelope.value, corridorWidth.value];
  const stations = useMemo(() => (line && line.length > 1 ? stationsAlong(line, width, stationCount) : []), [line, width]);
  const isAsked = run !== null && hasResults(run) && wanted !== '' && stations.length > 0;
  const key = isAsked ? `${run.done} ${width} ${JSON.stringify(line)}` : null;
  const answer = useRemote(run?.id ?? '', key, async (signal) => ({
    distances: stations.map(({ distance }) => distance),
    answers: await asking.stations(run!.id, stations.map((station) => station.line), signal),
  }));
  const envelope = useMemo(
    () => (wanted !== '' && answer.value ? envelopeOf(answer.value.distances, answer.value.answers, wanted, displayOf(envelopeChoices[wanted].unit)) : null),
    [answer.value, wanted, unitSystem.value],
  );
  return { envelope, error: isAsked ? answer.error : null };
}
