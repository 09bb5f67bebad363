// Keyboard focus of newly opened elements.

/// A `ref` that focuses an element when it is created. An inline function would be a new one on every render, and take
/// the focus each time.
export const focusOnceMade = (field: HTMLElement | null) => field?.focus();
