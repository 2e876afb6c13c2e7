package badlog.core.text

/**
 * Returns [wanted] followed by [ending]. If that is taken, returns the first free one of `wanted (2)`, `wanted (3)` and so on.
 *
 * @param isFree called for one name after another until it returns true; it may reserve that name.
 */
public inline fun freeName(wanted: String, ending: String = "", isFree: (String) -> Boolean): String {
    var name = wanted + ending
    var copy = 2
    while (!isFree(name)) name = "$wanted (${copy++})$ending"
    return name
}

/** Hands out each name once, in a time that does not grow with the number of requests for it. */
public class UniqueNames {
    private val given = HashSet<String>()
    private val copies = HashMap<String, Int>()

    /** Returns [wanted]. If that was handed out before, returns the first of `wanted (2)`, `wanted (3)` and so on that was not. */
    public fun give(wanted: String): String {
        var name = wanted
        var copy = copies[wanted] ?: 2
        while (!given.add(name)) name = "$wanted (${copy++})"
        copies[wanted] = copy
        return name
    }
}
