// Where the keyboard stands when something opens.

/// As a `ref`: the field has the focus when it is made. A function written in place would be another one whenever the
/// page is drawn again, and take the focus each time from what is being typed elsewhere.
export const focusOnceMade = (field: HTMLElement | null) => field?.focus();
