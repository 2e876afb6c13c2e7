package badlog.web

/**
 * The reasons to refuse a request.
 *
 * @property status the HTTP status.
 * @property text a sentence for the client.
 */
internal enum class Refusal(val status: Int, val text: String) {
    HOST(421, "This robot does not go by that name: open it by its address, such as http://10.TE.AM.2:5806/, or as robot.local."),
    METHOD(405, "This server only shows logs, and changes nothing: ask with GET."),
    MISSING(404, "There is no such log on this robot; / shows those that there are."),
    RANGE(416, "The log has no bytes there."),
    FIELD(503, "The robot is connected to the field: its logs can be opened after the match."),
    ENABLED(503, "The robot is enabled: its logs can be opened once it is disabled."),
    BEHIND(503, "The robot is enabled, and Live is more than a megabyte behind: press Live again once it is disabled."),
    BUSY(503, "Two downloads are running already: try again when one has ended."),
    UNREADABLE(500, "The log cannot be read: its disk may have been removed."),
}
