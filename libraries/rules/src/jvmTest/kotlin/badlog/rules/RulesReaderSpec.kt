package badlog.rules

import badlog.rules.cause.CauseGraph
import badlog.signals.vocabulary.SignalVocabulary
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlin.time.Duration.Companion.milliseconds

private const val RULE = "[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"x > 1\"\ntext = \"t\"\n"

private fun messageOf(rules: String): String = shouldThrow<RulesException> { RulesFile.parse(rules) }.message

class RulesReaderSpec : FunSpec({
    test("the built-in rules can be read") {
        RuleSet.BUILT_IN.rules.map { it.name }.take(2) shouldBe listOf("Browned out", "Below the brownout voltage")
    }

    test("the built-in rules in the build's JSON equal the ones in their file") {
        RuleSet.BUILT_IN.toJson(haveChecklist = true) shouldBe builtInRulesFromToml().toJson(haveChecklist = true)
        RuleSet.BUILT_IN.comparisons.size shouldBe builtInRulesFromToml().comparisons.size
    }

    test("damaged comparisons of a page are read or ignored, without an exception") {
        val whole = RuleSet(emptyList(), emptyList(), SignalVocabulary.NONE, CauseGraph.NONE, RuleSet.BUILT_IN.comparisons).toJson()
        checkNotNull(RuleSet.fromJson(whole)).toJson() shouldBe whole
        fun damaged(part: Regex, by: String) = RuleSet.fromJson(whole.replaceFirst(part, by).also { check(it != whole) })
        damaged(Regex("\"severity\":\"[A-Z]+\""), "\"severity\":\"FATAL\"") shouldBe null
        damaged(Regex("\\{topic}"), "{subject}") shouldBe null
        damaged(Regex("\\{topic}"), "{topic") shouldBe null
        for (limits in listOf("[]", "[1,2,3]", "[1,2,3,4,5]", "[1,2,3,\"x\"]", "[1,2,3,-4]")) {
            damaged(Regex("\"limits\":\\[[^]]*]"), "\"limits\":$limits") shouldBe null
        }
        // Even rules over too few logs can be run.
        checkNotNull(damaged(Regex("\"limits\":\\[[^]]*]"), "\"limits\":[0,0,1,0]")).comparisons.first().others shouldBe 5
        val bytes = Arb.element("", "{", "}", "[", "]", ",", ":", "\"", "-", "e", "9", "x")
        checkAll(Arb.int(whole.indices), bytes) { at, byte -> RuleSet.fromJson(whole.replaceRange(at, at + 1, byte)) }
    }

    test("lines of the checklist come from the rules, each once, and are not in pages") {
        val rule = "severity=\"note\"\nwhen=\"a > 1\"\ntext=\"x\"\n"
        val own = listOf("A" to "Battery in", "B" to "Battery in", "C" to "Bumpers tight")
            .joinToString("") { (name, line) -> "[[rule]]\nname=\"$name\"\nchecklist=\"$line\"\n$rule" }
        val rules = RulesFile.parse(own).rules
        rules.checklist shouldBe listOf("Battery in", "Bumpers tight")
        checkNotNull(RuleSet.fromJson(rules.toJson())).checklist shouldBe emptyList()
        RulesFile.parse("extends = \"default\"\n$own").rules.checklist shouldBe RuleSet.BUILT_IN.checklist + rules.checklist
        RuleSet.BUILT_IN.checklist.size shouldBe 5
    }

    test("a file without rules is valid") {
        RulesFile.parse("").rules.rules shouldBe emptyList()
    }

    test("a byte order mark before the text is ignored") {
        RulesFile.parse("\uFEFF$RULE").rules.rules.single().name shouldBe "A"
    }

    test("hooks have a command, and may have a name and a time limit") {
        val hooks = RulesFile.parse("[[hook]]\ncommand = \"python3 x/a.py -v\"\n[[hook]]\nname = \"B\"\ncommand = \"b\"\nseconds = 1.5\n").hooks
        hooks.map { it.name } shouldBe listOf(null, "B")
        hooks.map { it.command } shouldBe listOf(listOf("python3", "x/a.py", "-v"), listOf("b"))
        hooks.map { it.timeLimit } shouldBe listOf(null, 1500.milliseconds)
    }

    test("a text that is not TOML is reported with line and caret") {
        messageOf("[aliases]\nb = \n") shouldStartWith "Line 2: This is not TOML: "
        messageOf("[aliases]\nb = \n") shouldContain "\nb = \n    ^"
    }

    val mistakes = mapOf(
        RULE.replace("note", "bad") to
            "Line 3: A severity is “error”, “warning” or “note”, not “bad”.\nseverity = \"bad\"\n            ^^^",
        RULE.replace("when", "wenn") to "Line 4: “wenn” is not a key of a rule",
        RULE.replace("text = \"t\"\n", "") to "Line 1: This rule has no “text”.\n[[rule]]\n^",
        RULE.replace("\"t\"", "\"a {b} c\"") to "Line 5: “{b}” is not a placeholder; the placeholders are {value}, ",
        RULE.replace("\"t\"", "\"a {b} c\"") to "\ntext = \"a {b} c\"\n          ^^^",
        RULE.replace("\"t\"", "\"a {b\"") to "This brace is never closed",
        RULE.replace("\"t\"", "7") to "Line 5: “text” is a text in quotes.",
        RULE + RULE to "Line 7: There are two rules named “A”.",
        RULE + "unit = \"A\"\n" to "Line 6: “unit” selects topics for “each”, which is missing",
        RULE + "each = [1]\n" to "Line 6: “each” is a list of texts",
        RULE + "only = []\n" to "Line 6: “only” is a list of texts",
        "rules = 1\n" to "Line 1: “rules” is not a key of the file",
        "rule = 1\n" to "Line 1: Each rule begins with [[rule]]",
        "hook = 1\n" to "Line 1: Each hook begins with [[hook]]",
        "[[hook]]\nname = \"h\"\n" to "Line 1: This hook has no “command”.",
        "[[hook]]\ncommand = \"\"\n" to "Line 2: “command” is a text in quotes.",
        "[[hook]]\ncommand = \"a 'b\"\n" to "Line 2: In the command “a 'b” a quote (') is never closed.\ncommand = \"a 'b\"\n           ^^^^",
        "[[hook]]\ncommand = \"a\"\nseconds = 0\n" to "Line 3: “seconds” is a number above 0",
        "[[hook]]\ncommand = \"a\"\nseconds = \"1\"\n" to "Line 3: “seconds” is a number above 0",
        "aliases = 1\n" to "Line 1: “aliases” must be a table",
        "[aliases]\ntime = [\"x\"]\n" to "Line 2: “time” cannot be an alias",
        "[aliases]\nnot = [\"x\"]\n" to "“not” cannot be an alias",
        "[aliases]\n\"a b\" = [\"x\"]\n" to "“a b” cannot be an alias",
        "[aliases]\na = { name = [\"x\"] }\n" to "“name” is not a key of an alias",
        "[aliases]\na = { unit = \"V\" }\n" to "“names” is a list of texts",
    )
    for ((rules, message) in mistakes) {
        test("refuses ${rules.replace('\n', ' ').takeLast(50)}: ${message.take(30)}") { messageOf(rules) shouldContain message }
    }

    test("any text becomes rules or a sentence") {
        val whole = RulesFile.BUILT_IN.source.lines().take(20).joinToString("\n") + "\n" + RULE
        checkAll(Arb.int(0, whole.length), Arb.string(0, 4)) { at, text ->
            try {
                RulesFile.parse(whole.take(at) + text + whole.drop(at + text.length))
            } catch (e: RulesException) {
                e.message shouldStartWith "Line ${e.lineNumber}: "
            }
        }
    }
})
