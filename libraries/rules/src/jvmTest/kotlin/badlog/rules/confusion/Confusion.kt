package badlog.rules.confusion

import badlog.samples.generated.GeneratedMatch
import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.Visibility
import java.io.File
import java.util.concurrent.atomic.AtomicInteger

/** How the diagnosis of a match with [fault] ended. */
internal class Diagnosis(val name: String, val naming: Naming, val fault: Fault, val outcome: Outcome, val headline: String) {
    val visibility: Visibility get() = fault.sightIn(naming).visibility
}

/** The claims about a match without a fault; empty if there are none. */
internal class Silence(val name: String, val naming: Naming, val isHard: Boolean, val headline: String) {
    val isSilent: Boolean get() = headline.isEmpty()
}

/**
 * Measures the claims of the built-in rules on generated matches, and writes the table. Arguments: the set; the seed (empty for the set's own); how
 * often each combination of fault, strength and naming occurs; the number of matches without a fault for each naming; the file.
 */
internal fun main(arguments: Array<String>) {
    val set = MatchSet.valueOf(arguments[0].uppercase())
    val seed = arguments[1].toLongOrNull() ?: set.seed
    requireNotNull(seed) { "The final set needs a seed, the hash of the commit that was frozen for it: -Pseed=…" }
    val diagnoses = inParallel(faultyMatches(set, seed, arguments[2].toInt())) { match ->
        val fault = checkNotNull(match.fault)
        val claims = claimsAbout(match.bytes, match.fileName)
        Diagnosis(match.name, match.naming, fault, outcomeOf(fault, match.evidence, claims), claims.firstOrNull()?.text.orEmpty())
    }
    val silences = inParallel(healthyMatches(set, seed, arguments[3].toInt())) { match ->
        Silence(match.name, match.naming, match.isHard, claimsAbout(match.bytes, match.fileName).firstOrNull()?.text.orEmpty())
    }
    val text = "# ${set.name.lowercase().replaceFirstChar(Char::uppercase)} set, seed $seed\n\n" + tables(set.namings, diagnoses, silences)
    println(text)
    File(arguments[4]).apply { parentFile.mkdirs() }.writeText(text + details(diagnoses, silences))
}

private fun <T> inParallel(matches: List<() -> GeneratedMatch>, examine: (GeneratedMatch) -> T): List<T> {
    val done = AtomicInteger()
    return matches.parallelStream().map { match ->
        examine(match()).also { if (done.incrementAndGet() % REPORTED == 0) System.err.println("${done.get()} of ${matches.size} matches") }
    }.toList()
}

private fun tables(namings: List<Naming>, diagnoses: List<Diagnosis>, silences: List<Silence>): String {
    val seen = diagnoses.filter { it.visibility == Visibility.CAUSE }
    val head = "| | matches | ${Outcome.entries.joinToString(" | ") { it.title }} |\n|---|---|${"---|".repeat(Outcome.entries.size)}\n"
    val byFault = FAULTS.joinToString("") { fault -> row(fault.id, seen.filter { it.fault == fault }) }
    val byNaming = namings.joinToString("") { naming -> row(naming.id, seen.filter { it.naming == naming }) }
    val all = Outcome.entries.joinToString("\n") { outcome ->
        "- ${outcome.title}: ${shareText(FAULTS.map { fault -> seen.filter { it.fault == fault } }) { it.outcome == outcome }}"
    }
    val unseen = diagnoses.filter { it.visibility != Visibility.CAUSE }
    val healthy = listOf("all" to silences, "hard" to silences.filter { it.isHard }).joinToString("\n") { (name, matches) ->
        "- $name: ${shareText(matches.map(::listOf)) { it.isSilent }} of ${matches.size} silent"
    }
    return "Over matches whose log shows the cause:\n\n$all\n\n$head$byFault\n$head$byNaming\n" +
        "Where the log cannot show the cause:\n\n$head${row("all", unseen)}\nMatches without a fault:\n\n$healthy\n"
}

private fun row(title: String, diagnoses: List<Diagnosis>): String {
    val counts = Outcome.entries.map { outcome -> diagnoses.count { it.outcome == outcome } }
    val shares = counts.joinToString(" | ") { if (it == 0) "" else "%.0f %%".format(100.0 * it / diagnoses.size) }
    return "| $title | ${diagnoses.size} | $shares |\n"
}

/** The details for an author who mends a rule. They are the outcomes of each fault in each naming, and the wrong claims. */
private fun details(diagnoses: List<Diagnosis>, silences: List<Silence>): String {
    val cells = diagnoses.filter { it.visibility == Visibility.CAUSE }.groupBy { "${it.fault} ${it.naming.id}" }.entries.joinToString("") {
        "- ${it.key}: ${it.value.joinToString(", ") { one -> one.outcome.title }}\n"
    }
    val wrong = diagnoses.filter { it.outcome == Outcome.WRONG }.joinToString("") { "- ${it.name}: ${it.headline}\n" }
    val loud = silences.filter { !it.isSilent }.joinToString("") { "- ${it.name}${if (it.isHard) " (hard)" else ""}: ${it.headline}\n" }
    return "\n## Cells\n\n$cells\n## Wrong\n\n$wrong\n## Not silent\n\n$loud"
}

private const val REPORTED = 100
