package badlog.report

import badlog.expression.Expression
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class QuestionCheckSpec : FunSpec({
    val mistakes = mapOf(
        "" to "Something is missing here",
        "min(Battery Voltage < 7" to "This parenthesis is never closed",
        "min(Battery Voltage)) < 7" to "This parenthesis was never opened",
        "Battery Voltage <" to "Something is missing here",
        "State == 'IDLE" to "This text is never closed",
        "\"Arm/Angle > 3" to "This name is never closed",
        "3 and 4" to "condition",
        "x".repeat(4001) to "at most 4000 characters",
    )
    for ((question, message) in mistakes) {
        test("“${question.take(40)}” is wrong whatever a log has") {
            errorForEveryLog(question).shouldNotBeNull().message shouldContain message
        }
    }

    val names = mapOf(
        "Arm (left) > 3" to "Arm (left)",
        "mean(a, b, c) > 3" to "mean(a, b, c)",
        "/SmartDashboard/x > 3" to "/SmartDashboard/x",
        "Driver's Stick > 3" to "Driver's Stick",
        "min Battery < 3" to "min Battery",
        "\"Say \"\"x\"\"\" > 3" to "Say \"x\"",
        "Arm-2 V > 3" to "Arm-2 V",
    )
    for ((question, name) in names) {
        test("“$question” is right for a log that has such a topic") {
            Expression.parse(question, Vocabulary(listOf(Signal(name, SignalKind.NUMBER, "")))).shouldBeInstanceOf<Expression>()
            errorForEveryLog(question) shouldBe null
        }
    }

    test("no question is wrong because of an unknown topic") {
        val pieces = Arb.element("ab /().<>=-'\",3sx".map { Codepoint(it.code) })
        checkAll(Arb.string(0, 20, pieces)) { question ->
            (errorForEveryLog(question)?.kind != ExpressionErrorKind.UNKNOWN_TOPIC).shouldBeTrue()
        }
    }

    test("a question that is wrong for any log is reported without reading one") {
        inFolder { folder ->
            folder.put("1.bag", "no log at all")
            val find = Find("min(Battery Voltage < 7")
            find.mistake.shouldNotBeNull().pointed shouldContain "\nmin(Battery Voltage < 7\n   ^"
            find.over(logsIn(folder)).single().reply shouldBe find.mistake
        }
    }
})
