package badlog.viewer.app

/**
 * Something the pointer does, as the help sheet says it.
 *
 * @property group under which heading.
 * @property gesture what to do.
 * @property meaning what comes of it.
 */
internal data class GestureHelp(val group: String, val gesture: String, val meaning: String)
