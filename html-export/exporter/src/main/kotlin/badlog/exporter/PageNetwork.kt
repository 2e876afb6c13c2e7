package badlog.exporter

/**
 * What a page may ask of a network. Pages with a log, and files on a disk, may ask nothing.
 *
 * @property policy the part of the page's policy that allows it.
 * @property word what the facts in the page call it, for the page's program; null for nothing.
 */
enum class PageNetwork(internal val policy: String, internal val word: String?) {
    /** Nothing, ever. */
    NONE("", null),

    /** Its own server, which is a robot's: the page lists its logs. */
    ROBOT("connect-src 'self'; ", "robot"),

    /** Its own server, and others by https: a link may name a log there, which the page asks for when its reader agrees. */
    WEB("connect-src 'self' https:; ", "web"),
}
