package badlog.rules.folder

import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.SignalsFile
import badlog.rules.pack.packFolder
import badlog.rules.pack.ruleText
import badlog.rules.pack.zipped
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path

private fun writeRule(folder: Path, name: String, severity: String = "note"): Path = Files.writeString(
    folder.resolve(RulesFile.NAME),
    "[[rule]]\nname = \"$name\"\nseverity = \"$severity\"\nwhen = \"A > 1\"\ntext = \"t\"\n",
)

class FolderRulesSpec : FunSpec({
    test("the rules are from the log's folder, otherwise from a folder above it up to the top, otherwise the built-in ones") {
        val above = tempdir().toPath()
        val top = Files.createDirectories(above.resolve("logs"))
        val day = Files.createDirectories(top.resolve("day 1/morning"))
        val log = day.resolve("a.bag")
        writeRule(above, "Outside")
        FolderRules.of(log, top).rules shouldBe RuleSet.BUILT_IN
        val file = writeRule(top, "Above")
        FolderRules.of(log, top).rules.rules.map { it.name } shouldContainExactly listOf("Above")
        FolderRules.of(log, top).file shouldBe file
        FolderRules.of(log).rules shouldBe RuleSet.BUILT_IN
        writeRule(day, "Own")
        FolderRules.of(log, top).rules.rules.map { it.name } shouldContainExactly listOf("Own")
        FolderRules.of(log, above.resolve("elsewhere")).rules.rules.map { it.name } shouldContainExactly listOf("Own")
    }

    test("for a file with a mistake, the place is reported, and the built-in rules are used") {
        val folder = tempdir().toPath()
        writeRule(folder, "A", severity = "bad")
        val rules = FolderRules.of(folder.resolve("a.bag"), folder)
        rules.rules shouldBe RuleSet.BUILT_IN
        rules.file shouldBe null
        val problem = rules.problem.shouldNotBeNull()
        problem.lines()[0] shouldContain "badlog-rules.toml: Line 3:"
        problem.lines()[2].trim() shouldBe "^^^"
        Files.write(folder.resolve(RulesFile.NAME), byteArrayOf(-1, -2, 0))
        FolderRules.of(folder.resolve("a.bag"), folder).problem.shouldNotBeNull() shouldContain "not UTF-8 text"
    }

    test("a file that is nested too deeply is a problem like any other, not a crash") {
        val folder = tempdir().toPath()
        val depth = 100_000
        for (text in listOf("aliases = " + "[".repeat(depth) + "]".repeat(depth), "a" + ".a".repeat(depth) + " = 1", "a=" + "{a=".repeat(depth))) {
            Files.writeString(folder.resolve(RulesFile.NAME), text)
            val rules = FolderRules.of(folder.resolve("a.bag"), folder)
            rules.rules shouldBe RuleSet.BUILT_IN
            rules.problem.shouldNotBeNull().lines()[0] shouldContain "The built-in rules are used instead of"
        }
    }

    test("packs beside the logs add their rules, signals and devices, as folders and as zips") {
        val folder = tempdir().toPath()
        val log = folder.resolve("day/a.bag")
        Files.createDirectories(log.parent)
        val devices = "can_map.json" to "[{\"id\": 3, \"name\": \"Front left\"}]"
        val pack = folder.packFolder("b.badlog-rules", RulesFile.NAME to ruleText("Of b"), devices)
        val signals = SignalsFile.NAME to "[[signal]]\nname = \"hood angle\"\ntopics = [\"Hood\"]\n"
        val other = folder.packFolder("other", RulesFile.NAME to ruleText("Of a", "hood angle > 1"), signals)
        val zip = zipped(other, folder.resolve("a.badlog-rules.zip"))
        val found = FolderRules.of(log, folder)
        found.packs shouldBe listOf(zip, pack)
        found.problem shouldBe null
        found.file shouldBe null
        found.rules.rules.map { it.name } shouldBe RuleSet.BUILT_IN.rules.map { it.name } + listOf("Of a", "Of b")
        found.rules.signals.find("hood angle").shouldNotBeNull()
        found.rules.devices.devices.map { it.name } shouldBe listOf("Front left")
        FolderRules.of(log).rules shouldBe RuleSet.BUILT_IN
        writeRule(folder, "Own")
        FolderRules.of(log, folder).rules.rules.map { it.name } shouldBe listOf("Own", "Of a", "Of b")
        FolderRules.of(log, folder).file shouldBe folder.resolve(RulesFile.NAME)
    }

    test("a rule of a pack replaces a built-in one, and a rule of the folder replaces it") {
        val folder = tempdir().toPath()
        folder.packFolder("a.badlog-rules", RulesFile.NAME to ruleText("Low battery", "A > 5"))
        fun condition() = FolderRules.of(folder.resolve("a.bag")).rules.rules.single { it.name == "Low battery" }.condition
        condition() shouldBe "A > 5"
        Files.writeString(folder.resolve(RulesFile.NAME), ruleText("Low battery", "A > 7"))
        condition() shouldBe "A > 7"
    }

    test("a wrong pack, or one with another meaning for the same name, is reported, and the others are used") {
        val folder = tempdir().toPath()
        folder.packFolder("a.badlog-rules", RulesFile.NAME to "[aliases]\narm = \"A\"\n" + ruleText("One"))
        folder.packFolder("b.badlog-rules", RulesFile.NAME to ruleText("One"))
        folder.packFolder("c.badlog-rules", RulesFile.NAME to "[aliases]\narm = \"B\"\n" + ruleText("Two"))
        folder.packFolder("d.badlog-rules", RulesFile.NAME to "[[hook]]\ncommand = \"x\"\n")
        folder.packFolder("e.badlog-rules", RulesFile.NAME to "[aliases]\narm = \"A\"\n" + ruleText("Three"))
        Files.writeString(folder.resolve("f.badlog-rules.zip"), "no zip")
        val found = FolderRules.of(folder.resolve("a.bag"))
        found.packs.map { "${it.fileName}" } shouldBe listOf("a.badlog-rules", "e.badlog-rules")
        val problems = found.problem.shouldNotBeNull().lines().filter { it.startsWith("A pack of rules is not used: ") }
        problems.size shouldBe 4
        for (text in listOf("both have a rule “One”", "The alias “arm” of", "“hook” is not a key", "is not a zip")) problems.count { text in it } shouldBe 1
    }
})
