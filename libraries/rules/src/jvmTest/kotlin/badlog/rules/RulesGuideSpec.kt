package badlog.rules

import badlog.rules.pack.DeviceMap
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
    if (System.getenv("BADLOG_WRITE_GUIDE") != null) guide.writeText(made)
    made shouldBe written
}

class RulesGuideSpec : FunSpec({
    test("the guide has the built-in rules, each with its limits") {
        val tables = listOf("rule", "comparison").flatMap { key ->
            val source = checkNotNull(Toml.parse(resource(RulesFile.NAME)).getArray(key))
            (0 until source.size()).map { source.get(it) as TomlTable }
        }
        val text = tables.groupBy { it.getString("group").orEmpty() }.entries.joinToString("\n\n") { (group, rules) ->
            val rows = rules.joinToString("\n") { rule ->
                val limits = rule.getTable("limits")?.run { keySet().map { "*$it* ${get(listOf(it))}" } }.orEmpty()
                "| ${rule.getString("name")} | ${rule.getString("severity")} | ${limits.joinToString("<br>")} | ${rule.getString("why")} |"
            }
            "**$group**\n\n| rule | severity | limits | why |\n|---|---|---|---|\n$rows"
        }
        checkGuide("rules.md", "rules", text)
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
        changed.first { it.name == "Low battery" }.condition shouldBe "(battery < 6.8 and battery > 1) for 0.1 s"
    }
})
