// Requests that take longer than anyone expects, so that nobody waits without a word.

import { computed, signal } from '@preact/signals';

const patience = 20_000; // ms
const late = signal(0);

/// Whether an answer is overdue. It may come yet: a large terrain takes its time.
export const isOverdue = computed(() => late.value > 0);

export async function patiently<T>(answer: Promise<T>): Promise<T> {
  let isLate = false;
  const timer = setTimeout(() => {
    isLate = true;
    ++late.value;
  }, patience);
  try {
    return await answer;
  } finally {
    clearTimeout(timer);
    if (isLate) --late.value;
  }
}
