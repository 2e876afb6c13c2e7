package badlog.cli.pack

import badlog.cli.input.Failure
import badlog.core.json.quotedJson
import badlog.files.writeAtomically
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.pack.RulePack
import java.nio.file.Files
import java.nio.file.Path

/**
 * The file of rules of the pack [folder], which may not exist yet.
 *
 * @throws Failure if there is a folder with something else in it.
 * @throws badlog.rules.pack.PackException if something in the pack is wrong.
 */
internal class PackRules(folder: Path) {
    private val file = folder.resolve(RulesFile.NAME)

    /** The names of its rules; empty if there is no pack yet. */
    private val names: List<String> = when {
        Files.exists(file) -> RulePack.open(folder).use { pack -> pack.rules.rules.map { it.name } }
        !Files.exists(folder) || isEmpty(folder) -> emptyList()
        else -> throw Failure("$folder is a folder without ${RulesFile.NAME}, so it is not a pack; name a new one.")
    }

    private fun isEmpty(folder: Path) = Files.isDirectory(folder) && Files.newDirectoryStream(folder).use { it.none() }

    /** Returns whether there is a rule [name] that slices can test, in the pack or built in. */
    fun has(name: String): Boolean = name in names || RuleSet.BUILT_IN.rules.any { it.name == name }

    /** Writes the file if it does not exist, and adds a rule [name] with [condition] unless that is null. */
    fun add(name: String, condition: String?) {
        val before = if (Files.exists(file)) Files.readString(file).trimEnd() + "\n" else BEGINNING
        val text = if (condition == null) before else "$before\n${ruleText(name, condition)}"
        writeAtomically(file) { it.write(text.encodeToByteArray()) }
    }

    private fun ruleText(name: String, condition: String) = """
        |[[rule]]
        |name = ${quoted(name)}
        |severity = "warning"
        |when = ${quoted(condition)}
        |text = ${quoted("${name.replace("{", "{{").replace("}", "}}")} at {time} ({count}×).")}
        |
    """.trimMargin()

    /** Names in a condition are in double quotes, which need no backslash within single ones. */
    private fun quoted(text: String) = if ('"' in text && text.none { it == '\'' || it.isISOControl() }) "'$text'" else quotedJson(text)
}

private const val BEGINNING = "# The rules of this pack; docs/rules.md explains the keys.\n"
