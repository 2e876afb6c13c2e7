package badlog.viewer.compare

import java.nio.file.Path

/**
 * Which recordings are laid over the open one.
 *
 * @property ticked the files of those, in the order in which they were ticked.
 */
internal data class Comparison(val ticked: List<Path> = emptyList())
