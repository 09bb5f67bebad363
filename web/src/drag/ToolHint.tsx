import { dragHint } from './drag';
import { finishTool, tool, useTool } from '../tools/tool';

/// The hint of the active tool.
export function ToolHint() {
  if (dragHint.value !== null)
    return (
      <div class="tool-hint" role="status">
        <strong>{dragHint.value}</strong>
        <span>Ctrl rounds to a grid, Alt does not snap, Escape cancels.</span>
      </div>
    );
  if (!tool.value) return null;
  return (
    <div class="tool-hint" role="status">
      <strong>{tool.value.name}</strong>
      <span>{tool.value.hint()}</span>
      {tool.value.finish && (
        <button class="button" onClick={finishTool}>
          Finish
        </button>
      )}
      <button class="button" title="Close the tool (Escape)" onClick={() => useTool(null)}>
        Close
      </button>
    </div>
  );
}
