package badlog.viewer.state

/** The screens of a page that opens logs, in the order in which one leads to the next. */
enum class Visit {
    /** The page as it begins: without a log, or with its own. */
    START,

    /** The list of a folder's logs. */
    LIST,

    /** A log. */
    LOG,
}

/**
 * The screens that a browser's Back and Forward go through. Immutable; each transition returns a new one.
 *
 * @property at the place of the shown screen among the entries of the browser's history, counted from the page's first.
 */
class LogVisits private constructor(private val entries: List<Visit>, val at: Int) {
    constructor() : this(listOf(Visit.START), 0)

    /** The shown screen. */
    val now: Visit get() = entries[at]

    /**
     * Returns the visits after [next] is shown. Its place is one further for a new entry of the browser's history, or an earlier one if
     * that entry already showed [next]. A log that follows another one takes over its entry.
     */
    fun showing(next: Visit): LogVisits {
        if (next > now) return LogVisits(entries.take(at + 1) + next, at + 1)
        val before = entries.take(at + 1).lastIndexOf(next)
        return if (before < 0) replaced(next) else LogVisits(entries, before)
    }

    /** Returns the visits when the shown screen has one more entry, because the end of the address has changed. */
    fun again(): LogVisits = LogVisits(entries.take(at + 1) + now, at + 1)

    /**
     * Returns the visits when the browser goes to [place]. If [canShow] is false for its screen, the screens before it in order are tried.
     * Null if this page did not make the entry.
     */
    fun returned(place: Int, canShow: (Visit) -> Boolean): LogVisits? {
        val wanted = entries.getOrNull(place) ?: return null
        val shown = Visit.entries.last { it <= wanted && (it == Visit.START || canShow(it)) }
        return LogVisits(entries, place).replaced(shown)
    }

    private fun replaced(visit: Visit) = LogVisits(entries.mapIndexed { i, old -> if (i == at) visit else old }, at)
}
