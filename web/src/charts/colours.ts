// The colours of runs in figures.

/// Of the shown run alone.
export const shownColour = 'var(--accent)';
/// The colours of two compared runs.
export const firstColour = 'var(--run-shown)';
export const secondColour = 'var(--run-compared)';
