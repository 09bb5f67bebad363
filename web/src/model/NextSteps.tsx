import { values } from '../state/document';
import { chosen } from '../state/view';
import { add, nextSteps } from './things';

/// What to do next in a project that cannot run yet.
export function NextSteps() {
  const steps = nextSteps(values.value);
  if (steps.length === 0) return null;
  const act = { terrain: 'Make the terrain', material: 'Add a material', seeder: 'Add a seeder' };
  return (
    <section class="next-steps" aria-label="Next steps">
      <h2>Next</h2>
      <ol>
        {steps.map(({ key, what }, k) => (
          <li key={key}>
            <span>{what}</span>
            <button
              class={`button ${k === 0 ? 'first' : ''}`}
              onClick={() => (key === 'terrain' ? (chosen.value = ['terrain']) : add(key))}
            >
              {act[key]}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}
