package badlog.charts

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Tests of charts of simulated matches, as shown in the guide. With the environment variable `BADLOG_WRITE_GUIDE`, its pictures are
 * rewritten.
 */
class SampleSeasonSpec : FunSpec({
    val charts = chartsOf(sampleSeason(24))

    test("the matches with a tired battery stand out") {
        charts.all.map { it.name } shouldContainAll listOf("battery", "loop-times", "loops-per-match", "battery-over-current", "resistance", "packet-loss")
        val resistance = charts.all.single { it.name == "resistance" }.svg()
        // Once below the axis, and once at its point.
        for (tired in listOf("Q14", "Q50")) Regex(">\\s*$tired\\s*<").findAll(resistance).count() shouldBe 2
        resistance shouldContain "Resistance of battery and wiring · Mill Creek Regional"
    }

    test("the pictures of the guide are charts of these matches") {
        for (chart in charts.all) {
            val picture = Path.of("../../docs/chart-${chart.name}.svg")
            if (System.getenv("BADLOG_WRITE_GUIDE") != null) picture.writeText(chart.svg())
            picture.readText() shouldContain "aria-label=\"${chart.title}\""
        }
    }
})
