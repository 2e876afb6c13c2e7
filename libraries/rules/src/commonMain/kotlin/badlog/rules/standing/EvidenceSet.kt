package badlog.rules.standing

/**
 * A set of logs in which the findings of rules were counted.
 *
 * @property id its name in the table of counts.
 * @property title its name for people.
 * @property isReal whether the logs are of real robots.
 */
enum class EvidenceSet(val id: String, val title: String, val isReal: Boolean = false) {
    REAL("real", "real logs", isReal = true),
    GENERATED("generated", "generated matches"),
    PLANTED("planted", "second simulator"),
    THIRD("third", "third simulator"),
    FIFTH("fifth", "fifth simulator"),

    /** Logs of healthy robots that a reviewer made to mislead a rule: each finding is wrong. */
    REVIEW("review", "made to mislead"),
}
