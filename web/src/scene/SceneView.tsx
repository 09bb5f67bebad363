export function SceneView() {
  return <div class="empty">Scene</div>;
}
