package badlog.core.recording

/** Collects problems in bounded memory: of each kind and topic, the first ten are kept and the others only counted. */
public class ProblemList {
    private val problems = ArrayList<Problem>()
    private val seen = HashMap<Pair<ProblemKind, String?>, Int>()
    private val overflow = LinkedHashMap<Pair<ProblemKind, String?>, Problem>()

    /** Whether nothing was added. */
    public val isEmpty: Boolean get() = problems.isEmpty()

    /** Adds a [Problem]. */
    public fun add(kind: ProblemKind, message: String, line: Int? = null, topic: String? = null, count: Int = 1, loss: Loss = Loss.NONE) {
        val key = kind to topic
        val times = (seen[key] ?: 0) + 1
        seen[key] = times
        val problem = Problem(kind, message, line, topic, count, loss)
        if (times <= MAX_LISTED) {
            problems += problem
        } else {
            val first = overflow[key] ?: problem.copy(count = 0, loss = Loss.NONE)
            overflow[key] = first.copy(count = first.count + count, loss = first.loss + loss)
        }
    }

    /**
     * Returns the problems in the order in which they were added, then one for the rest of each kind and topic that occurred more than ten
     * times.
     */
    public fun toList(): List<Problem> = problems + overflow.values
}

private const val MAX_LISTED = 10
