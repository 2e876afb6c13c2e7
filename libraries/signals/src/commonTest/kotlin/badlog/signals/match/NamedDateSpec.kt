package badlog.signals.match

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class NamedDateSpec : FunSpec({
    // On a clock on the wall: 16 March 2024, 10:41:07.
    val time = 1_710_585_667L

    listOf(
        "FRC_20240316_104107.bag" to time,
        "badlog-2024-03-16_10-41-07.bag" to time,
        "akit_24-03-16_10-41-07.csv" to time,
        "log_20240316T104107.bag" to time,
        "2024.03.16 10.41.bag" to time - 7,
        "20240316.bag" to time - 7 - 41 * 60 - 10 * 3600,
        "FRC_20240229_000000.bag" to 1_709_164_800L,
    ).forEach { (name, second) ->
        test("the name “$name” shows the date") { dateInName(name)?.second shouldBe second }
    }

    listOf("99999999_999999.bag", "FRC_20230229_000000.bag", "FRC_20240316_254107.bag", "FRC_19700101_000012.bag", "a.bag").forEach { name ->
        test("the name “$name” shows no date") { dateInName(name)?.second shouldBe null }
    }

    listOf(
        "2024-03-16T10:41:07",
        "2024-03-16T10:41:07.123456",
        "2024-03-16 10:41:07",
        "03/16/2024 10:41:07",
        "20240316_104107",
        "03/16/2024 10:41:07 AM",
        "Mar 16, 2024, 10:41:07\u202FAM",
        "Mar 16, 2024 10:41:07 AM",
        "Saturday, March 16, 2024 at 10:41:07 AM",
        "Sat Mar 16 10:41:07 2024",
        "Sat Mar 16 10:41:07 XYZ 2024",
        "16 Mar 2024 10:41:07",
    ).forEach { text ->
        test("the text “$text” is that time") { dateInText(text) shouldBe time }
    }

    listOf(
        "2024-03-16T10:41:07Z",
        "2024-03-16 10:41:07 UTC",
        "2024-03-16T11:41:07.5+01:00",
        "2024-03-16T05:11:07-0530",
        "2024-03-16T06:41:07.123-04:00[America/New_York]",
        "Sat, 16 Mar 2024 06:41:07 -0400",
        "Sat, 16 Mar 2024 10:41:07 GMT",
        "16 Mar 2024 10:41:07 GMT",
        "Sat Mar 16 06:41:07 EDT 2024",
        "Sat Mar 16 11:41:07 GMT+01:00 2024",
        "$time",
        "${time}000",
    ).forEach { text ->
        test("the text “$text” is a moment, shown as the local time of day") { dateInText(text) shouldBe localSecondOf(time) }
    }

    test("no text makes it throw, and every date that is found is believable") {
        val odd = listOf("1e300", "-1e300", "999999999999999999999", "-99999999999", "NaN123456789", "2024-02-30T00:00:00", "2024-03-16T10:41:07+99:00", "Sat, 32 Mar 2024 10:41:07 GMT", "Sat, 16 Mrz 2024 10:41:07 GMT", "03/16/2024 13:41:07 PM")
        for (text in odd) dateInText(text) shouldBe null
        checkAll(Arb.string(0, 40)) { text -> dateInText(text)?.let { (it in 946_000_000L..7_259_000_000L) shouldBe true } }
    }
})
