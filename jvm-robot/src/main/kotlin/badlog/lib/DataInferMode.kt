package badlog.lib

/** What a subscriber topic's cell holds when nothing was published since the last [BadLog.updateTopics]. */
public enum class DataInferMode {
    /** The default, [BadLog.DEFAULT_DATA]. */
    DEFAULT,

    /** What was published last; the default before anything was. */
    LAST,
}
