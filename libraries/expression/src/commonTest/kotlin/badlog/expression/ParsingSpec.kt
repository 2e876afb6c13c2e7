package badlog.expression

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.expression.syntax.Node
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import kotlin.random.Random

private val VOCABULARY = Vocabulary(
    listOf(
        "a", "b", "c", "x", "System/Battery Voltage", "Elevator/Current", "Intake/Current", "Arm", "Arm/Angle", "A-B",
        "Not Moving", "min", "say \"go\"",
    )
        .map { Signal(it, SignalKind.NUMBER) } +
        listOf("p", "q", "System/Enabled").map { Signal(it, SignalKind.CONDITION) } + Signal(
            "State",
            SignalKind.STATE,
        ) + Signal("Log", SignalKind.EVENT),
)

private const val OVER_AT_ONCE =
    "A moment has no duration; count(c) counts moments, and hold(x) keeps the text of an event until the next."

private fun shapeOf(text: String) = shape(parsed(text, VOCABULARY).root)

private fun error(text: String) = errorOf(text, VOCABULARY)

class ParsingSpec : FunSpec({
    val precedences = mapOf(
        "a + b * c" to "(+ a (* b c))",
        "a - b - c" to "(- (- a b) c)",
        "a / b % c" to "(% (/ a b) c)",
        "-a ^ 2" to "(neg (^ a 2.0))".replace("2.0", "${2.0}"),
        "a ^ b ^ c" to "(^ a (^ b c))",
        "a ^ -b * c" to "(* (^ a (neg b)) c)",
        "-a * b" to "(* (neg a) b)",
        "a + b < c * x" to "(< (+ a b) (* c x))",
        "p or q and p" to "(or p (and q p))",
        "p || q && p" to "(or p (and q p))",
        "not p and q" to "(and (not p) q)",
        "!a < b" to "(not (< a b))",
        "! p && q" to "(and (not p) q)",
        "7 % 3 + a" to "(+ (% 7 3) a)".replace(Regex("[73]")) { "${it.value.toDouble()}" },
        "a < b for 1 s" to "(for (< a b) 1s)".replace("1s", "${1.0}s"),
        "not p for 1 s" to "(for (not p) 1s)".replace("1s", "${1.0}s"),
        "p and q for 1 s" to "(and p (for q 1s))".replace("1s", "${1.0}s"),
        "p and q for 1 s or p" to "(or (and p (for q 1s)) p)".replace("1s", "${1.0}s"),
        "a when p and q" to "(when a (and p q))",
        "a when p when q" to "(when (when a p) q)",
        "a < b when p or q" to "(when (< a b) (or p q))",
        "a = b" to "(== a b)",
        "a ≤ b or a =< b" to "(or (<= a b) (<= a b))",
        "a ≥ b or a => b" to "(or (>= a b) (>= a b))",
        "a <> b or a ≠ b" to "(or (!= a b) (!= a b))",
        "a − −b" to "(- a (neg b))",
        "(a < b) == (b < c)" to "(== (< a b) (< b c))",
        "a<b&&b>=c" to "(and (< a b) (>= b c))",
        "p AND NOT q" to "(and p (not q))",
    )
    for ((text, shape) in precedences) test("“$text” is read as $shape") { shapeOf(text) shouldBe shape }

    val names = mapOf(
        "min(System/Battery Voltage) < 7" to "(< (MIN System/Battery Voltage) 7)",
        "Battery Voltage - 1" to "(- System/Battery Voltage 1)",
        "system/battery voltage" to "System/Battery Voltage",
        "\"Battery Voltage\"" to "System/Battery Voltage",
        "/System/Battery Voltage" to "System/Battery Voltage",
        "\"/System/Battery Voltage\"" to "System/Battery Voltage",
        "a / /Arm/Angle" to "(/ a Arm/Angle)",
        "`Battery Voltage`" to "System/Battery Voltage",
        "\"say \"\"go\"\"\"" to "say \"go\"",
        "`say \"go\"`" to "say \"go\"",
        "Elevator/Current" to "Elevator/Current",
        "Arm/Angle" to "Arm/Angle",
        "Arm / a" to "(/ Arm a)",
        "Arm/2" to "(/ Arm 2)",
        "Arm/max(a)" to "(/ Arm (MAX a))",
        "\"Arm\"/a" to "(/ Arm a)",
        "time" to "time",
        "Time" to "time",
        "teleop" to "teleop",
        "A-B" to "A-B",
        "a - b" to "(- a b)",
        "Not Moving > 1" to "(> Not Moving 1)",
        "min > 1" to "(> min 1)",
        "min(min)" to "(MIN min)",
        "MAX (a)" to "(MAX a)",
        "enabled" to "enabled",
        "Enabled" to "System/Enabled",
        "autonomous" to "autonomous",
    )
    for ((text, shape) in names) {
        test("the names in “$text” are found") {
            // The text of a whole number depends on the platform.
            shapeOf(text) shouldBe shape.replace(Regex("(?<= )[0-9]")) { "${it.value.toDouble()}" }
        }
    }

    test("the longest name wins, but not one that ends within a word") {
        val vocabulary = names("Speed", "Speed Limit", "Speed Limited")
        shape(parsed("Speed Limit", vocabulary).root) shouldBe "Speed Limit"
        errorOf("Speed Limiter", vocabulary).message shouldContain "“Speed Limiter” is not a topic of this log. Did you mean “Speed Limited”?"
    }

    test("times need units, and numbers do not") {
        val written = listOf(
            "2 h",
            "0.5min",
            "3 s",
            "20 ms",
            "7 us",
            "7 µs",
            "1:30",
            "1:00:02.5",
            "5 sec",
            "2 Minutes",
        ).map { parsed("time - $it", VOCABULARY).root.children[1] as Node.Time }
        written.map { it.seconds } shouldBe listOf(7200.0, 30.0, 3.0, 0.02, 7e-6, 7e-6, 90.0, 3602.5, 5.0, 120.0)
        (parsed("1.5e3", VOCABULARY).root as Node.Number).value shouldBe 1500.0
        (parsed(".5", VOCABULARY).root as Node.Number).value shouldBe 0.5
    }

    test("a time has no meaning if x is not a time") {
        val rows = Vocabulary(VOCABULARY.signals, hasTime = false)
        errorOf("a > 1 for 5 s", rows).run {
            kind shouldBe ExpressionErrorKind.NO_TIME
            message shouldBe
                "The x axis of this log is not a time, so “5 s” has no meaning; give it an x axis with a unit of time."
            text.substring(from, until) shouldBe "5 s"
        }
        for (text in listOf("mean(a, 5 s) > 1", "time > -5 s", "time > 5", "shift(a, 1 s) > 1")) errorOf(text, rows).kind shouldBe ExpressionErrorKind.NO_TIME
        parsed("max(a) > 5", rows).topics shouldBe listOf("a")
        (rows == VOCABULARY) shouldBe false
    }

    val errors = listOf(
        Triple(
            "min(Battery Voltge) < 7",
            "Battery Voltge",
            "“Battery Voltge” is not a topic of this log. Did you mean “System/Battery Voltage”?",
        ),
        Triple("max(zzzzzzzz) < 7", "zzzzzzzz", "“zzzzzzzz” is not a topic of this log."),
        Triple("\"Arn\" > 1", "\"Arn\"", "“Arn” is not a topic of this log. Did you mean “Arm”?"),
        Triple("Current > 5", "Current", "“Current” may mean “Elevator/Current” or “Intake/Current”."),
        Triple("mim(a) < 1", "mim", "There is no function “mim”; did you mean min?"),
        Triple("frobnicated(a) < 1", "frobnicated", "There is no function “frobnicated”."),
        Triple("max < 1", "max", "max is a function; put its operands in parentheses after it."),
        Triple("clamp(a, 1)", "clamp(a, 1)", "clamp takes 3 operands, not 2."),
        Triple("mean()", "mean()", "mean takes 1 operand or 2 operands, not 0."),
        Triple("a +", "", "Something is missing here: a topic, a number or a function."),
        Triple("", "", "Something is missing here: a topic, a number or a function."),
        Triple("a + * b", "*", "Something is missing before “*”."),
        Triple("and a", "and", "Something is missing before “and”."),
        Triple("min(,a)", ",", "Something is missing before “,”."),
        Triple("a # b", "#", "“#” is not expected here; an operator such as + or < may follow, or the end."),
        Triple("a b", "b", "“b” is not expected here; an operator such as + or < may follow, or the end."),
        Triple("# > a", "#", "“#” is not expected here."),
        Triple("(a + b", "(", "This parenthesis is never closed."),
        Triple("a + b)", ")", "This parenthesis was never opened."),
        Triple("p & q", "&", "“&” is not an operator; write “&&”."),
        Triple("a < 1,5", ",", "A comma only separates the operands of a function; write decimals with a point."),
        Triple("State == 'IDLE", "'IDLE", "This text is never closed; ' is missing."),
        Triple("\"Arm", "\"Arm", "This name is never closed; \" is missing."),
        Triple("a < 7 V", "7 V", "“a” has no unit, so 7 V cannot be compared with it; write the number alone, as it is logged."),
        Triple("a < 1e999", "1e999", "This number is too large."),
        Triple("a < 1e305 h", "1e305 h", "This time is too long."),
        Triple("a < b < c", "<", "Comparisons cannot be chained; write “a < b and b < c”."),
        Triple("a > 1 for x", "for", "“for” needs a time after it, as in for 0.5 s."),
        Triple("a > 1 for 5", "5", "“for” needs a time after it, as in for 0.5 s."),
        Triple("a > 1 for 0 s", "0 s", "“for” needs a time above 0 after it."),
        Triple("min(a) > 1 for 1 s", "min(a) > 1", "“for” needs a condition that changes over time before it."),
        Triple("a and p", "a", "A condition is needed here, but “a” is a number; compare it, as in x > 0."),
        Triple("not State", "State", "A condition is needed here, but “State” is a text; compare it, as in x == 'IDLE'."),
        Triple("p when a + b", "a + b", "A condition is needed here, but this is a number; compare it, as in x > 0."),
        Triple("State + 1", "State", "A number is needed here, not “State”, which is a text."),
        Triple("-'a'", "'a'", "A number is needed here, not a text."),
        Triple("State == 1", "State == 1", "A text, “State”, cannot be compared with a number; put texts in single quotes."),
        Triple("State == IDLE", "IDLE", "“IDLE” is not a topic of this log; put a text in single quotes, as in 'IDLE'."),
        Triple("State = \"STOWED\"", "\"STOWED\"", "“STOWED” is not a topic of this log; put a text in single quotes, as in 'STOWED'."),
        Triple("Log contains \"x y\"", "\"x y\"", "“x y” is not a topic of this log; put a text in single quotes, as in 'x y'."),
        Triple("a > 90 % for 1 s", "90 %", "“a” has no unit, so 90 % cannot be compared with it; write the number alone, as it is logged."),
        Triple(
            "max(Arm/a)",
            "Arm/a",
            "“Arm/a” is not a topic of this log. Did you mean “a”? To divide, put spaces around the slash: Arm / a.",
        ),
        Triple(
            "max(Arm/Enabled)",
            "Arm/Enabled",
            "“Arm/Enabled” is not a topic of this log. Did you mean “System/Enabled”? To divide, put spaces around the slash: Arm / Enabled.",
        ),
        Triple(
            "/System/Battery Voltge > 1",
            "/System/Battery Voltge",
            "“/System/Battery Voltge” is not a topic of this log. Did you mean “System/Battery Voltage”?",
        ),
        Triple(
            "Battery  Volts > 1",
            "Battery  Volts",
            "“Battery  Volts” is not a topic of this log. Did you mean “System/Battery Voltage”?",
        ),
        Triple("sum(a) > 1", "sum", "There is no function “sum”; did you mean integral?"),
        Triple("avg(a) > 1", "avg", "There is no function “avg”; did you mean mean?"),
        Triple(
            "max(a, b)",
            "b",
            "max needs a time above 0 with its unit, such as 1 s, not “b”, which is a number; to choose between two, use if(a < b, a, b).",
        ),
        Triple("'x' == a", "'x' == a", "A text, 'x', cannot be compared with “a”, which is a number."),
        Triple("'x' == 'y'", "'x' == 'y'", "Two fixed texts need no comparison; compare a topic with a text."),
        Triple("a contains 'x'", "a", "“contains” needs a topic of texts before it, not “a”, which is a number."),
        Triple("Log contains a", "a", "“contains” needs a text in single quotes after it."),
        Triple("max(a) > 3 when p", "max(a)", "max covers the whole log, so “when” has no effect; put it inside: max(x when c)."),
        Triple("count(p) when q", "count(p)", "count covers the whole log, so “when” has no effect; put it inside: count(x when c)."),
        Triple("1 + any(p) when q", "any(p)", "any covers the whole log, so “when” has no effect; put it inside: any(x when c)."),
        Triple("not (Log == 'a') for 1 s", "not (Log == 'a')", OVER_AT_ONCE),
        Triple("total(changed(Log))", "changed(Log)", OVER_AT_ONCE),
        Triple("'x' when p", "'x'", "A fixed text cannot have “when”."),
        Triple("State", "State", "This is a text, not an answer; compare it, as in State == 'IDLE'."),
        Triple("min(7)", "7", "min needs numbers that change over time, not a number."),
        Triple("any(a)", "a", "any needs a condition that changes over time, such as x > 0, not “a”, which is a number."),
        Triple("mean(a, 5)", "5", "mean needs a time above 0 with its unit, such as 1 s, not a number."),
        Triple("shift(a, b)", "b", "shift needs a time with its unit, such as 0.1 s, not “b”, which is a number."),
        Triple("percentile(a, 101)", "101", "percentile needs a number from 0 to 100, not a number."),
        Triple("during(a, 5 s)", "a", "during needs one number for the whole log, not “a”, which is a number."),
        Triple("if(a, 1, 2)", "a", "if needs a condition, such as x > 0, not “a”, which is a number."),
        Triple("if(p, State, 2)", "State", "if needs a number or a condition, not “State”, which is a text."),
        Triple("sqrt(State)", "State", "sqrt needs a number, not “State”, which is a text."),
        Triple("changed(7)", "7", "changed needs something that changes over time, not a number."),
    )
    for ((text, place, message) in errors) {
        test("“$text” is an error at “$place”") {
            val error = error(text)
            error.message shouldBe message
            text.substring(error.from, error.until) shouldBe place
        }
    }

    test("an error points at its place in its line") {
        error("a > 1\n and Battery Voltge < 7").pointed() shouldBe
            "“Battery Voltge” is not a topic of this log. Did you mean “System/Battery Voltage”?\n and Battery Voltge < 7\n     ^^^^^^^^^^^^^^"
        error("a +").pointed().lines().drop(1) shouldBe listOf("a +", "   ^")
    }

    test("an expression that is too long, too deep or too expensive is an error") {
        val long = "a" + " + a".repeat(5000)
        for (text in listOf(
            long, long.take(3900), "(".repeat(3999), "-".repeat(3999), "not ".repeat(900), "min(".repeat(900),
            "p for 1 s" + " for 1 s".repeat(300),
            "a" + " + shift(a, 1 s)".repeat(100), List(199) { "a" }.joinToString(" + ").let { "$it<1 or ".repeat(4) + "p" },
        )) {
            error(text).kind shouldBe ExpressionErrorKind.LIMIT
        }
        parsed("(".repeat(90) + "a" + ")".repeat(90), VOCABULARY).toString() shouldBe "\"a\""
        parsed(List(150) { "a" }.joinToString(" + "), VOCABULARY).toString().length shouldBe 150 * 3 + 149 * 3
    }

    test("any text is an expression, or an error within the text") {
        val pieces = listOf(
            "a", "p", "State", "System/", "Battery Voltage", "min", "max(", "if(", "(", ")", ",", "+", "-", "/", "*", "^", "%",
            "<", "=", "==", "!", "!=", "&", "&&", "|",
            "and", "or", "not", "for", "when", "contains", "matches", " ", " ", "  ", "'", "\"", "`", "'x'", "1", "0.5", ".",
            "e5", "s", "ms", "\n", "\u0000", "\uD800", "İ", "µ", "enabled", "true",
        )
        repeat(30 * PropertyTesting.defaultIterationCount) { seed ->
            val random = Random(seed)
            val text = List(random.nextInt(14)) { pieces[random.nextInt(pieces.size)] }
                .joinToString(if (random.nextBoolean()) " " else "")
            when (val result = Expression.parse(text, VOCABULARY)) {
                is Expression -> shape(parsed(result.toString(), VOCABULARY).root) shouldBe shape(result.root)

                is ExpressionError -> {
                    val isWithin = result.from in 0..text.length && result.until in result.from..text.length
                    if (!isWithin) throw AssertionError("“$text”: ${result.from}..${result.until}")
                    result.pointed()
                }
            }
        }
    }

    test("an expression with one wrong, missing or doubled character is an expression, or an error within it") {
        repeat(5 * PropertyTesting.defaultIterationCount) { seed ->
            val random = Random(seed)
            val vocabulary = randomSignals(random).vocabulary
            val text = RandomExpressions(random).any()
            val at = random.nextInt(text.length)
            val changed = text.substring(0, at) + listOf(
                "",
                text[at].toString().repeat(2),
                random.nextInt(0x20, 0x7f).toChar().toString(),
            ).random(random) + text.substring(at + 1)
            val result = Expression.parse(changed, vocabulary)
            if (result is ExpressionError) {
                (
                    result.from in 0..changed.length &&
                        result.until in result.from..changed.length
                    ) shouldBe true
            }
        }
    }

    test("a name with very many folders is found by its ends at the usual cost") {
        val vocabulary = names("a/".repeat(100_000) + "End", "/SmartDashboard/Speed", "Table/")
        parsed("a/a/End", vocabulary).topics.single().length shouldBe 200_003
        parsed("Speed + SmartDashboard/Speed + /SmartDashboard/Speed", vocabulary).topics shouldBe listOf("/SmartDashboard/Speed")
        parsed("Table/", vocabulary).topics shouldBe listOf("Table/")
    }

    test("an expression can be used with any equal vocabulary") {
        val other = Vocabulary(VOCABULARY.signals.map { it.copy() })
        (other == VOCABULARY) shouldBe true
        other.hashCode() shouldBe VOCABULARY.hashCode()
        (names("a") == VOCABULARY) shouldBe false
    }

    test("an expression shows which topics it uses and the kind of its result") {
        val expression = parsed("min(Battery Voltage) < 7 and a > 1 for 1 s and a < 5", VOCABULARY)
        expression.topics shouldBe listOf("System/Battery Voltage", "a")
        expression.type shouldBe ExpressionType(isCondition = true, isOverTime = true)
        expression.toString() shouldBe "min(\"System/Battery Voltage\") < 7 and \"a\" > 1 for 1 s and \"a\" < 5"
        parsed("max(a)", VOCABULARY).type shouldBe ExpressionType(isCondition = false, isOverTime = false)
    }
})
