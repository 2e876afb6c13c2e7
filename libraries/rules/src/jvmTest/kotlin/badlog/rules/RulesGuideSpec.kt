package badlog.rules

import badlog.rules.pack.DeviceMap
import badlog.rules.standing.EvidenceSet
import badlog.rules.standing.RuleCounts
import badlog.rules.standing.Standing
import badlog.rules.standing.lackingIn
import badlog.rules.standing.trustOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import org.tomlj.Toml
import org.tomlj.TomlTable
import java.io.File

/** Checks that the guide [file] has [text] between the marks of [part]; BADLOG_WRITE_GUIDE writes it there. */
private fun checkGuide(file: String, part: String, text: String) {
    val guide = File("../../docs/$file")
    val (begin, end) = listOf("begin", "end").map { "<!-- $part $it -->" }
    val written = guide.readText()
    val made = written.substringBefore(begin) + begin + "\n" + text.trimEnd() + "\n" + end + written.substringAfter(end)
    if (System.getenv("BADLOG_WRITE_GUIDE") != null) guide.writeText(made) else made shouldBe written
}

/** Returns how many of the findings in a simulator were right; empty if there were none. */
private fun rightText(counts: RuleCounts): String = (counts.right + counts.wrong).let { judged -> if (judged == 0) "" else "${counts.right} of $judged" }

class RulesGuideSpec : FunSpec({
    test("the guide has the built-in rules, each with its limits") {
        val tables = listOf("rule", "comparison").flatMap { key ->
            val source = checkNotNull(Toml.parse(resource(RulesFile.NAME)).getArray(key))
            (0 until source.size()).map { source.get(it) as TomlTable }
        }
        val text = tables.groupBy { it.getString("group").orEmpty() }.entries.joinToString("\n\n") { (group, rules) ->
            val rows = rules.joinToString("\n") { rule ->
                val limits = rule.getTable("limits")?.run { keySet().map { "*$it* ${get(listOf(it))}" } }.orEmpty()
                val standing = Standing.of(countedTrust(rule.getString("name").orEmpty(), hashOf(rule))).name.lowercase().replace('_', ' ')
                "| ${rule.getString("name")} | ${rule.getString("severity")} | $standing | ${limits.joinToString("<br>")} | ${rule.getString("why")} |"
            }
            "**$group**\n\n| rule | severity | standing | limits | why |\n|---|---|---|---|---|\n$rows"
        }
        checkGuide("rules.md", "rules", text)
    }

    test("the guide has the counts of each built-in rule, and the evidence that it lacks") {
        val head = "| rule | real logs (teams) | true | false | unknown | ${EvidenceSet.entries.filter { !it.isReal }.joinToString(" | ") { it.title }} | lacks |"
        val rows = hashesOfBuiltInRules().map { (rule, hash) ->
            val counts = COUNTS.filter { it.rule == rule && it.hash == hash }
            val real = counts.find { it.set.isReal }
            val cells = listOf("${real?.couldRun ?: 0} (${real?.teams ?: 0})", real?.right ?: 0, real?.wrong ?: 0, real?.unknown ?: 0) +
                EvidenceSet.entries.filter { !it.isReal }.map { set -> counts.find { it.set == set }?.let(::rightText).orEmpty() }
            val lacking = lackingIn(counts)
            val name = when (Standing.of(trustOf(counts))) {
                Standing.PROVEN -> "**$rule**"
                Standing.ON_TRIAL -> rule
                Standing.SILENT -> "*$rule*"
            }
            "| $name | ${cells.joinToString(" | ")} | ${lacking.joinToString("; ")} |"
        }
        val proven = rows.count { "**" in it }
        val silent = rows.count { it.startsWith("| *") } - proven
        checkGuide("findings.md", "standing", "$proven of ${rows.size} rules are proven, in bold type; $silent are silent, in italics.\n\n$head\n${"|---".repeat(EvidenceSet.entries.size + 5)}|\n${rows.joinToString("\n")}")
    }

    test("the guide has the built-in signals") {
        val signals = SignalsFile.parse(SignalsFile.builtInSource).signals
        val rows = signals.joinToString("\n") { signal ->
            "| `${signal.name}` | ${signal.meaning} | ${signal.unit.orEmpty()} | ${if (signal.isMany) "many" else ""} |"
        }
        checkGuide("signals.md", "signals", "| signal | means | unit | |\n|---|---|---|---|\n$rows")
    }

    test("the examples in the guides are correct") {
        val block = Regex("```([a-z-]+)\n((?:.*\n)*?)```")
        val examples = listOf("rules.md", "signals.md").flatMap { block.findAll(File("../../docs/$it").readText()) }
            .associate { it.groupValues[1] to it.groupValues[2] }
        SignalsFile.parse(examples.getValue("signals")).signals.map { it.name } shouldBe listOf("battery", "hood angle", "robot enabled")
        val changed = RulesFile.parse(examples.getValue("built-in-rules-changed")).rules.rules
        changed.none { it.group == "pneumatics" || it.name == "Flat sensor" } shouldBe true
        DeviceMap.parse(examples.getValue("devices")).devices.map { it.name } shouldBe listOf("Front left drive", "Hood")
        changed.first { it.name == "Low battery" }.condition shouldBe "(battery < 6.5 and battery > 1) for 0.1 s"
    }
})
