// Notices requests that take unusually long, so that the page can report it.

import { computed, signal } from '@preact/signals';

const limit = 20_000; // ms
const lateRequests = signal(0);

/// Whether a response is overdue. It may still arrive: a large terrain takes time.
export const isOverdue = computed(() => lateRequests.value > 0);

export async function noticingDelay<T>(answer: Promise<T>): Promise<T> {
  let isLate = false;
  const timer = setTimeout(() => {
    isLate = true;
    ++lateRequests.value;
  }, limit);
  try {
    return await answer;
  } finally {
    clearTimeout(timer);
    if (isLate) --lateRequests.value;
  }
}
