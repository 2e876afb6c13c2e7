package badlog.rules.confusion

import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Verdict

/** How the diagnosis of a match with a fault ended; each match has one of these. */
internal enum class Outcome(val title: String) {
    RIGHT("right cause"),
    SYMPTOM("true symptom"),
    WRONG("wrong cause"),
    SILENT("silence"),
}

/**
 * Returns how the diagnosis of a match with [fault] ended, with [claims] in the order of their list. The topics [evidence] show the fault.
 *
 * A list that begins with an incident of another cause is wrong, whatever follows: a team would act on that. Otherwise the best of all claims counts.
 * A claim that shows none of [evidence] is about something else, whatever it says.
 */
internal fun outcomeOf(fault: Fault, evidence: List<String>, claims: List<Claim>): Outcome {
    if (claims.isEmpty()) return Outcome.SILENT
    val verdicts = claims.map { claim ->
        val isShown = evidence.isEmpty() || claim.topics.isEmpty() || claim.topics.any { topic -> evidence.any(topic::startsWith) }
        if (isShown) fault.verdictOn(claim.text) else Verdict.OTHER
    }
    return when {
        claims[0].isIncident && verdicts[0] == Verdict.OTHER -> Outcome.WRONG
        Verdict.CAUSE in verdicts -> Outcome.RIGHT
        Verdict.SYMPTOM in verdicts -> Outcome.SYMPTOM
        else -> Outcome.WRONG
    }
}
