package badlog.viewer.draw.path

/**
 * A log that graphs of y over x draw.
 *
 * @property paths what they can draw of it.
 * @property name its name beside the others.
 * @property offset what is added to its x.
 */
class XyLog(val paths: LogPaths, val name: String = "", val offset: Double = 0.0)
