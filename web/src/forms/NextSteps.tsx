import { values } from '../project/document';
import { choose } from '../project/chosen';
import { add, nextSteps } from '../project/things';

/// The next steps of a project that cannot run yet.
export function NextSteps() {
  const steps = nextSteps(values.value);
  if (steps.length === 0) return null;
  const actions = { terrain: 'Define the terrain', material: 'Add a material', seeder: 'Add a seeder' };
  return (
    <section class="next-steps" aria-label="Next steps">
      <h2>Next</h2>
      <ol>
        {steps.map(({ key, what }, k) => (
          <li key={key}>
            <span>{what}</span>
            <button
              class={`button ${k === 0 ? 'first' : ''}`}
              onClick={() => (key === 'terrain' ? choose(['terrain']) : add(key))}
            >
              {actions[key]}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}
