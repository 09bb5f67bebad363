// A view as it is seen, as a file.

import { fileStem } from '../state/document';

export function savePicture(canvas: HTMLCanvasElement | null) {
  canvas?.toBlob((blob) => {
    if (!blob) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${fileStem() || 'view'}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  });
}
