package badlog.files

import java.nio.file.Files
import java.nio.file.Path

/**
 * The place for results, as typed after `--out`.
 *
 * @property path the file or folder.
 * @property isFolder whether it is a folder: one that exists, a name with a slash at its end, or, if nothing exists there, a name without an ending.
 *   Users who type `page` nearly always want a folder.
 */
public class ResultPlace private constructor(public val path: Path, public val isFolder: Boolean) {
    public companion object {
        /**
         * Returns the place that [text] names.
         *
         * @throws java.nio.file.InvalidPathException if it cannot be a path.
         */
        public fun of(text: String): ResultPlace {
            val path = Path.of(text)
            val name = path.fileName?.toString().orEmpty()
            val hasEnding = name.lastIndexOf('.') in 1 until name.lastIndex
            val endsWithSlash = text.endsWith('/') || text.endsWith('\\')
            return ResultPlace(path, endsWithSlash || if (Files.exists(path)) Files.isDirectory(path) else !hasEnding)
        }
    }
}
