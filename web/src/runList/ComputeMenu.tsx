// The Compute button and its menu with options of the run.

import { useEffect, useRef, useState } from 'preact/hooks';
import { valueAt } from '../project/document';
import { model, problems } from '../project/model';
import { compute } from '../runs/runs';
import { showPanel } from '../state/panels';
import { setVaries, varies } from '../state/varies';
import { focusOnceMade } from '../ui/focus';
import './runs.css';

const wholeNumber = (text: string) => (text.trim() === '' ? undefined : Number(text));

function Options({ close }: { close: () => void }) {
  const seed = valueAt(['sampling', 'seed']);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    const form = new FormData(event.currentTarget as HTMLFormElement);
    const [name, rocks, draw] = ['name', 'rocks', 'seed'].map((key) => String(form.get(key) ?? ''));
    const [rockCount, seedNumber] = [wholeNumber(rocks!), wholeNumber(draw!)];
    close();
    showPanel('runs');
    void compute({
      ...(name!.trim() && { name: name!.trim() }),
      ...(rockCount !== undefined && { rocks: rockCount }),
      ...(seedNumber !== undefined && { seed: seedNumber }),
    });
  };
  return (
    <form class="compute-menu" aria-label="Options of the run" onSubmit={submit}>
      <label>
        Name of the run
        <input name="name" maxLength={200} placeholder="project name" ref={focusOnceMade} />
      </label>
      <label>
        Number of rocks in all
        <input name="rocks" type="number" min={1} max={1e12} step={1} placeholder={String(model.value?.rocks ?? '')} />
      </label>
      <label>
        Seed
        <input
          name="seed"
          type="number"
          min={0}
          max={Number.MAX_SAFE_INTEGER}
          step={1}
          placeholder={seed === undefined ? 'as in the project' : String(seed)}
        />
      </label>
      <p class="faint">Empty fields use the project's values.</p>
      <label class="choice" title="After each run, in the background: the ranges of its answers. Otherwise on request">
        <input type="checkbox" checked={varies.value} onChange={(event) => setVaries(event.currentTarget.checked)} />
        Then vary inputs and rock models
      </label>
      <button class="button first" style={{ justifyContent: 'center' }}>
        Compute this run
      </button>
    </form>
  );
}

export function ComputeMenu() {
  const [isOpen, open] = useState(false);
  const box = useRef<HTMLDivElement>(null);
  const hasErrors = problems.value.some(({ severity }) => severity === 'error');
  useEffect(() => {
    if (!isOpen) return;
    const outside = (event: Event) => {
      if (!box.current?.contains(event.target as Node)) open(false);
    };
    addEventListener('pointerdown', outside);
    addEventListener('focusin', outside);
    return () => {
      removeEventListener('pointerdown', outside);
      removeEventListener('focusin', outside);
    };
  }, [isOpen]);
  const close = () => {
    open(false);
    box.current?.querySelector<HTMLButtonElement>('[aria-haspopup]')?.focus();
  };
  const why = hasErrors ? 'The model has errors, listed in the panel on the left' : null;
  return (
    <div
      class="compute"
      ref={box}
      onKeyDown={(event) => {
        if (event.key === 'Escape' && isOpen) {
          event.stopPropagation();
          close();
        }
      }}
    >
      <button class="button first" disabled={hasErrors} title={why ?? 'Run the project (Ctrl+Enter)'} onClick={() => void compute()}>
        Compute
      </button>
      <button
        class="button first icon"
        disabled={hasErrors}
        title={why ?? 'Name, number of rocks, seed'}
        aria-label="Options of the run"
        aria-haspopup="dialog"
        aria-expanded={isOpen}
        onClick={() => open(!isOpen)}
      >
        ▾
      </button>
      {isOpen && <Options close={close} />}
    </div>
  );
}
