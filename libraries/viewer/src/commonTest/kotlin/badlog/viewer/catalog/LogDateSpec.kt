package badlog.viewer.catalog

import badlog.core.recording.Value
import badlog.signals.match.localSecondOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LogDateSpec : FunSpec({
    // 16 March 2024, 10:41:07, on a local wall clock.
    val time = 1_710_585_667L
    val written = 1_735_787_045L

    fun date(name: String, vararg values: Value) = LogDate.of(values.toList(), name, written * 1000)

    test("a value shows the date, before the name does") {
        date("20180101.bag", Value("Start Time", "2024-03-16T10:41:07")) shouldBe LogDate(time, DateSource.VALUES)
    }

    test("the name shows the date, before the time of the file") {
        date("FRC_20240316_104107.bag") shouldBe LogDate(time, DateSource.FILE_NAME)
    }

    test("without either, a log is as old as its file, by the local wall clock") {
        date("a.bag") shouldBe LogDate(localSecondOf(written), DateSource.FILE_TIME)
    }

    test("a date from a clock that was never set is ignored") {
        date("FRC_19700101_000012.bag", Value("Start Time", "1970-01-01T00:00:12")).source shouldBe DateSource.FILE_TIME
    }
})
