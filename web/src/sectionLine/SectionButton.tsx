import { useTool } from '../tools/tool';
import { drawSection, isDrawing } from './sectionLine';

export function SectionButton() {
  const isOn = isDrawing();
  return (
    <button
      class="button"
      aria-pressed={isOn}
      title="Draw a line to see the ground along it"
      onClick={() => (isOn ? useTool(null) : drawSection())}
    >
      Section
    </button>
  );
}
