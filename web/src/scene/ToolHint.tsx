import { finishTool, tool, useTool } from './tool';

/// What the active tool asks for.
export function ToolHint() {
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
      <button class="button" title="Leave the tool (Escape)" onClick={() => useTool(null)}>
        Leave
      </button>
    </div>
  );
}
