import { problems } from '../state/model';

export function ModelPanel() {
  return (
    <div style={{ padding: 10 }}>
      {problems.value.map((problem) => (
        <span key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </span>
      ))}
    </div>
  );
}
