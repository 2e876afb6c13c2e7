package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class UnitsSpec : FunSpec({
    test("a unit of time is recognized however it is spelled") {
        listOf("h", "Hours", "min", "minutes", "s", " sec ", "Seconds", "ms", "milliseconds", "us", "\u00b5s", "\u03bcs", "ns")
            .map { Units.secondsIn(it) } shouldBe
            listOf(3600.0, 3600.0, 60.0, 60.0, 1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-6, 1e-6, 1e-6, 1e-9)
    }

    test("other units are not units of time") {
        for (unit in listOf("", "ul", "m", "V", "Index", "m/s", "1")) Units.secondsIn(unit) shouldBe null
    }

    test("microseconds are whole in every common unit") {
        listOf("s", "ms", "us", "min", "V").map { Units.microsIn(it) } shouldBe listOf(1e6, 1e3, 1.0, 60e6, 1e6)
    }
})
