package badlog.viewer.draw.path

/**
 * A log that graphs of y over x draw.
 *
 * @property paths the log's content for such graphs.
 * @property name the log's name beside the others.
 * @property offset the number that is added to the log's x.
 */
class XyLog(val paths: LogPaths, val name: String = "", val offset: Double = 0.0)
