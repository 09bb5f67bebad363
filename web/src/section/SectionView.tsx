export function SectionView() {
  return <div class="empty">Section</div>;
}
