package badlog.exporter

/**
 * The servers to which a page may send requests. Pages with a log, and pages on a disk, may use none.
 *
 * @property policy the part of the page's policy that allows these requests.
 * @property word the name of the network in the page's facts, which the page's program reads; null for [NONE].
 */
enum class PageNetwork(internal val policy: String, internal val word: String?) {
    /** No server, ever. */
    NONE("", null),

    /** The page's own server on a robot. The page lists the robot's logs. */
    ROBOT("connect-src 'self'; ", "robot"),

    /** The page's own server, and others by https. A link may name a log there, which the page requests if its reader agrees. */
    WEB("connect-src 'self' https:; ", "web"),
}
