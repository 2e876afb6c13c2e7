package badlog.exporter

/**
 * The servers that a page may ask. Pages with a log, and files on a disk, may ask none.
 *
 * @property policy the part of the page's policy that allows it.
 * @property word the name in the page's facts, for the page's program; null for [NONE].
 */
enum class PageNetwork(internal val policy: String, internal val word: String?) {
    /** No server, ever. */
    NONE("", null),

    /** The page's own server on a robot. The page lists the robot's logs. */
    ROBOT("connect-src 'self'; ", "robot"),

    /** The page's own server, and others by https. A link may name a log there, which the page requests if its reader agrees. */
    WEB("connect-src 'self' https:; ", "web"),
}
