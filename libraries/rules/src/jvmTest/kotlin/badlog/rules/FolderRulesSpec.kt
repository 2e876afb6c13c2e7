package badlog.rules

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
    test("the rules are those of the log's folder, otherwise of a folder above it up to the top, otherwise the built-in ones") {
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
})
