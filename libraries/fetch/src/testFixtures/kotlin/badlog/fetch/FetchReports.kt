package badlog.fetch

import java.time.Duration

/** The reports of a fetch, in their order. */
class FetchReports(private val onWaiting: () -> Unit = {}, private val onProgress: (Long) -> Unit = {}) : FetchListener {
    val said = ArrayList<String>()

    override fun connected(address: RobotAddress, user: String) {
        said += "connected to $address as $user"
    }

    override fun waiting(address: RobotAddress) {
        said += "waiting"
        onWaiting()
    }

    override fun retrying(address: RobotAddress, reason: String) {
        said += "retrying"
    }

    override fun found(logs: FoundLogs) {
        said += "found ${logs.newLogs} new, ${logs.knownLogs} known"
    }

    override fun advanced(name: String, done: Long, total: Long) = onProgress(done)

    override fun fetched(log: FetchedLog) {
        said += "fetched ${log.path} from ${log.resumedAt}"
    }

    override fun skipped(path: String, message: String, isGrowing: Boolean) {
        said += message
    }

    override fun deleted(path: String) {
        said += "deleted $path"
    }
}

/** Waits for everything as long as a busy machine may take, but hardly before another look. */
val IMPATIENCE = Patience(
    connect = Duration.ofSeconds(60),
    answer = Duration.ofSeconds(60),
    silence = Duration.ofSeconds(60),
    growth = Duration.ofMillis(20),
    retry = Duration.ofMillis(10),
    state = Duration.ofSeconds(60),
)

/** A person who trusts every robot, or none, and counts the questions. */
class Person(private val isTrusting: Boolean = true, private val password: String? = null) : FetchQuestions {
    val questions = ArrayList<String>()

    override fun trusts(question: HostKeyQuestion): Boolean {
        questions += if (question.isChanged) "changed" else "unknown"
        return isTrusting
    }

    override fun password(user: String, address: RobotAddress): String? {
        questions += "password of $user"
        return password
    }
}

/** Returns a bag of the match [number] with [rows] rows. */
fun matchBag(number: Int, rows: Int = 50): String = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Speed","unit":"m/s"}],""")
    append(""""values":[{"name":"Event Name","value":"MILLC"},{"name":"Match Type","value":"Qualification"},{"name":"Match Number","value":"$number"}]}""")
    append("\nTime,Speed\n")
    repeat(rows) { append("${it * 0.02},${it % 7}.5\n") }
}
