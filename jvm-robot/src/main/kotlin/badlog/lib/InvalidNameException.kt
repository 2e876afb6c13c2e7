package badlog.lib

/** Not thrown by anything: unusual names are only warned of. Here for programs that mention it. */
public class InvalidNameException : RuntimeException() {
    private companion object {
        const val serialVersionUID: Long = -2518114606252953907L
    }
}
