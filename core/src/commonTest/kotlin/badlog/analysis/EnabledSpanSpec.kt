package badlog.analysis

import badlog.analysis.Span
import badlog.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val HEADER =
    """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"System/Enabled","unit":"ul","attrs":["hide"]},""" +
        """{"name":"System/Autonomous","unit":"ul","attrs":[]}],"values":[]}"""

private fun spans(vararg rows: String): List<EnabledSpan> {
    val parser = BagParser()
    val titles = "Time,System/Enabled,System/Autonomous"
    parser.accept((listOf(HEADER, titles) + rows).joinToString("\n", postfix = "\n").encodeToByteArray())
    return LogView.of(parser.finish()).enabledSpans()
}

class EnabledSpanSpec : FunSpec({
    test("autonomous and driven stretches follow one another, and what is disabled is none") {
        spans("0,false,true", "1,true,true", "2,true,false", "3,true,false", "4,false,false", "5,true,false") shouldBe listOf(
            EnabledSpan(Span(1.0, 2.0), isAutonomous = true),
            EnabledSpan(Span(2.0, 4.0), isAutonomous = false),
            EnabledSpan(Span(5.0, 5.0), isAutonomous = false),
        )
    }

    test("numbers show as truth values do") {
        spans("0,0,0", "1,1.0000,0", "2,0,0") shouldBe listOf(EnabledSpan(Span(1.0, 2.0), isAutonomous = false))
    }

    test("where no topic shows, and where x goes backwards, nothing is claimed") {
        val parser = BagParser()
        parser.accept("Time,On\n0,true\n1,true\n".encodeToByteArray())
        LogView.of(parser.finish()).enabledSpans() shouldBe emptyList()
        spans("1,true,false", "0,true,false") shouldBe emptyList()
        spans() shouldBe emptyList()
    }
})
