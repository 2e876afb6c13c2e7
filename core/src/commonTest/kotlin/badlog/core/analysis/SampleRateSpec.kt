package badlog.core.analysis

import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe

class SampleRateSpec : FunSpec({
    fun rateOver(x: String, rows: String): Double {
        val bag = """{"topics":[$x,{"name":"Speed"}]}""" + "\nT,Speed\n$rows"
        val recording = BagParser().run {
            accept(bag.encodeToByteArray())
            finish()
        }
        return LogView.of(recording).run { sampleRateOf(recording.topics.last()) }
    }

    test("the rate counts samples per second, whatever the unit of time, gaps included") {
        val rows = "0,1\n20,\n40,3\n60,4\n"
        rateOver("""{"name":"T","unit":"ms","attrs":["xaxis"]}""", rows) shouldBe (50.0 plusOrMinus 1e-9)
        rateOver("""{"name":"T","unit":"s","attrs":["xaxis"]}""", rows) shouldBe (0.05 plusOrMinus 1e-9)
        rateOver("""{"name":"T","attrs":["xaxis"]}""", rows) shouldBe (0.05 plusOrMinus 1e-9)
    }

    test("a distance axis, a row index and a single sample give no sample rate") {
        rateOver("""{"name":"T","unit":"m","attrs":["xaxis"]}""", "0,1\n20,2\n").shouldBeNaN()
        rateOver("""{"name":"T","unit":"s"}""", "0,1\n20,2\n").shouldBeNaN()
        rateOver("""{"name":"T","unit":"s","attrs":["xaxis"]}""", "0,1\n").shouldBeNaN()
    }
})
