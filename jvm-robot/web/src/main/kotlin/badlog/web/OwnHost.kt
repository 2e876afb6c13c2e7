package badlog.web

/**
 * Returns whether [header], the `Host` of a request, is a name that only a robot has, or an address. Any other name may belong to a web
 * page that points its name here to read the answers (DNS rebinding).
 */
internal fun isOwnHost(header: String): Boolean = HOST.matches(header)

private val HOST = Regex(
    """(\d{1,3}(\.\d{1,3}){3}|\[[0-9a-f:.]+]|localhost|robot\.local|roborio-\d{1,5}-frc(\.local|\.lan|\.frc-field\.local)?)(:\d{1,5})?""",
    RegexOption.IGNORE_CASE,
)
