package badlog.lib

/** The content of a subscriber topic's cell if nothing was published since the last [BadLog.updateTopics]. */
public enum class DataInferMode {
    /** The default, [BadLog.DEFAULT_DATA]. */
    DEFAULT,

    /** The last published value; the default until there is one. */
    LAST,
}
