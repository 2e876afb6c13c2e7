package badlog.viewer.findings

import badlog.report.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

class RulesForSpec : FunSpec({
    test("the rules are those of the log's folder, else of the folders above it up to the library, else badlog's own") {
        val top = tempdir().toPath()
        val library = Files.createDirectories(top.resolve("logs"))
        val day = Files.createDirectories(library.resolve("day 1/morning"))
        val log = day.resolve("a.bag")
        writeRules(top, ruleText("Outside", "A > 1"))
        RulesFor.of(log, library).set shouldBe RuleSet.DEFAULT
        val above = writeRules(library, ruleText("Above", "A > 1"))
        RulesFor.of(log, library).set.rules.map { it.name } shouldContainExactly listOf("Above")
        RulesFor.of(log, library).file shouldBe above
        RulesFor.of(log, library = null).set shouldBe RuleSet.DEFAULT
        writeRules(day, ruleText("Own", "A > 1"))
        RulesFor.of(log, library).set.rules.map { it.name } shouldContainExactly listOf("Own")
        RulesFor.of(log, library = top.resolve("elsewhere")).set.rules.map { it.name } shouldContainExactly listOf("Own")
    }

    test("of a file with a mistake the place is told, and the default rules are used") {
        val folder = tempdir().toPath()
        writeRules(folder, "[[rule]]\nname = \"A\"\nseverity = \"bad\"\nwhen = \"A > 1\"\ntext = \"t\"\n")
        val rules = RulesFor.of(folder.resolve("a.bag"), folder)
        rules.set shouldBe RuleSet.DEFAULT
        rules.file shouldBe null
        val trouble = rules.trouble.shouldNotBeNull()
        trouble.lines()[0] shouldContain "badlog-rules.toml: Line 3:"
        trouble.lines()[2].trim() shouldBe "^^^"
        Files.write(folder.resolve(RulesFor.NAME), byteArrayOf(-1, -2, 0))
        RulesFor.of(folder.resolve("a.bag"), folder).trouble.shouldNotBeNull() shouldContain "no text"
    }

    test("no program of a file of rules is run") {
        val folder = tempdir().toPath()
        val ran = folder.resolve("ran")
        writeRules(folder, ruleText("A", "A > 5"), "[[hook]]\nname = \"Evil\"\ncommand = \"touch '$ran'\"\n")
        findingsIn(counted(folder)).all.map { it.rule } shouldContainExactly listOf("A")
        Files.exists(ran) shouldBe false
    }
})
