package badlog.samples.generated

import badlog.core.json.quotedJson
import badlog.samples.generated.fault.Naming
import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * Writes matches into a folder, each with a JSON file of the same name that describes its fault. Arguments: folder, count, seed, and a
 * naming or `all`.
 */
fun main(arguments: Array<String>) {
    if (arguments.size != 4) fail("There are ${arguments.size} arguments; give a folder, a count, a seed and a naming.")
    val (folder, count, seed, naming) = arguments
    val namings = if (naming == "all") Naming.entries else Naming.entries.filter { it.id == naming }
    if (namings.isEmpty()) fail("There is no naming “$naming”; use all, ${Naming.entries.joinToString { it.id }}.")
    val number = count.toIntOrNull() ?: fail("The count is “$count”; use a whole number.")
    val generator = MatchGenerator(seed.toLongOrNull() ?: fail("The seed is “$seed”; use a whole number."))
    val directory = Files.createDirectories(Path.of(folder))
    for (match in generator.matches(namings).take(number)) {
        Files.write(directory.resolve(match.fileName), match.bytes)
        Files.writeString(directory.resolve("${match.name}.json"), describe(match))
        println("${match.fileName}: ${match.fault?.cause ?: "No fault, ${match.hardship}."}")
    }
}

private fun fail(message: String): Nothing {
    System.err.println(message)
    exitProcess(2)
}

/** Returns the description of [match] as JSON. */
internal fun describe(match: GeneratedMatch): String {
    val members = LinkedHashMap<String, String>()
    members["file"] = quotedJson(match.fileName)
    members["naming"] = quotedJson(match.naming.id)
    members["hardship"] = quotedJson(match.hardship)
    val fault = match.fault
    if (fault != null) {
        members["fault"] = quotedJson(fault.id)
        members["strength"] = match.strength.toString()
        members["cause"] = quotedJson(fault.cause)
        members["acceptedPhrases"] = texts(fault.causes.map { it.toString() })
        members["symptomPhrases"] = texts(fault.symptoms.map { it.toString() })
        members["strengthMeans"] = quotedJson(fault.strength)
        members["start"] = decimals(match.start ?: 0.0)
        members["part"] = quotedJson(match.part)
        members["visible"] = quotedJson(fault.sightIn(match.naming).visibility.name.lowercase())
        members["because"] = quotedJson(fault.sightIn(match.naming).reason)
        members["evidence"] = texts(match.evidence)
    }
    return members.entries.joinToString(",\n", "{\n", "\n}\n") { "  ${quotedJson(it.key)}: ${it.value}" }
}

private fun texts(texts: List<String>) = texts.joinToString(", ", "[", "]") { quotedJson(it) }
