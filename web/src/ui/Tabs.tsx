import type { ComponentChildren } from 'preact';

interface Props<Name extends string> {
  label: string;
  tabs: { name: Name; title: ComponentChildren }[];
  now: Name;
  choose: (name: Name) => void;
}

/// A row of tabs; arrow keys move between them.
export function Tabs<Name extends string>({ label, tabs, now, choose }: Props<Name>) {
  const go = (event: KeyboardEvent) => {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const k = tabs.findIndex(({ name }) => name === now);
    const next = tabs[(k + step + tabs.length) % tabs.length]!;
    choose(next.name);
    const list = event.currentTarget as HTMLElement;
    (list.children[tabs.indexOf(next)] as HTMLElement).focus();
  };
  return (
    <div class="tabs" role="tablist" aria-label={label} onKeyDown={go}>
      {tabs.map(({ name, title }) => (
        <button
          key={name}
          role="tab"
          aria-selected={name === now}
          tabIndex={name === now ? 0 : -1}
          onClick={() => choose(name)}
        >
          {title}
        </button>
      ))}
    </div>
  );
}
