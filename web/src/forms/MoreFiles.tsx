import { files, hasMoreFiles } from '../project/files';

/// A notice if the list of files is truncated.
export function MoreFiles() {
  if (!hasMoreFiles.value) return null;
  return (
    <p class="problem warning more-files">
      Only {files.value.length.toLocaleString('en')} files of the folder are listed. Start talus serve in a smaller
      folder to see all files.
    </p>
  );
}
