package badlog.viewer.library

import java.nio.file.Path

/**
 * The folder of logs as the window shows it.
 *
 * @property folder it; null before one was opened.
 */
internal data class LibraryState(val folder: Path? = null)
