package badlog.text

/**
 * [wanted] followed by [ending], or where that is not free, the first of `wanted (2)`, `wanted (3)` and so on that is.
 *
 * @param isFree is asked for one name after another until it says true; it may take that name at the same time.
 */
public inline fun freeName(wanted: String, ending: String = "", isFree: (String) -> Boolean): String {
    var name = wanted + ending
    var copy = 2
    while (!isFree(name)) name = "$wanted (${copy++})$ending"
    return name
}

/** Gives each name away once, in a time that does not grow with how often one is wanted. */
public class UniqueNames {
    private val given = HashSet<String>()
    private val copies = HashMap<String, Int>()

    /** [wanted], or where that was given before, the first of `wanted (2)`, `wanted (3)` and so on that was not. */
    public fun give(wanted: String): String {
        var name = wanted
        var copy = copies[wanted] ?: 2
        while (!given.add(name)) name = "$wanted (${copy++})"
        copies[wanted] = copy
        return name
    }
}
