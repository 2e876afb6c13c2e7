package badlog.window.folder.index

import badlog.core.recording.Value
import badlog.files.LogFile
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.nio.file.Path
import java.time.Instant
import java.time.LocalDateTime
import java.time.ZoneId

class LogDateSpec : FunSpec({
    val written = LocalDateTime.of(2025, 1, 2, 3, 4, 5)

    fun date(name: String, start: String? = null): LogDate {
        val millis = written.atZone(ZoneId.systemDefault()).toInstant().toEpochMilli()
        return LogDate.of(listOfNotNull(start?.let { Value("Start Time", it) }), LogFile(Path.of(name), 1, millis))
    }

    listOf(
        "FRC_20240910_002949.bag" to LocalDateTime.of(2024, 9, 10, 0, 29, 49),
        "badlog-2024-03-16_10-41-07.bag" to LocalDateTime.of(2024, 3, 16, 10, 41, 7),
        "akit_24-03-16_10-41-07.csv" to LocalDateTime.of(2024, 3, 16, 10, 41, 7),
        "2018.04.14 10.22.bag" to LocalDateTime.of(2018, 4, 14, 10, 22),
        "20240316.bag" to LocalDateTime.of(2024, 3, 16, 0, 0),
        "log_20240316T104107.bag" to LocalDateTime.of(2024, 3, 16, 10, 41, 7),
    ).forEach { (name, time) ->
        test("the name “$name” shows the date") {
            date(name).time shouldBe time
            date(name).source shouldBe DateSource.FILE_NAME
        }
    }

    listOf(
        "2018-04-14T10:22:03",
        "2018-04-14T10:22:03.123456",
        "2018-04-14 10:22:03",
        "04/14/2018 10:22:03",
        "20180414_102203",
    ).forEach { text ->
        test("the value “$text” shows the date, before the name") {
            date("20240316.bag", text).time.withNano(0) shouldBe LocalDateTime.of(2018, 4, 14, 10, 22, 3)
            date("20240316.bag", text).source shouldBe DateSource.VALUES
        }
    }

    test("a time that says UTC is reported as the time of day here") {
        val here = LocalDateTime.ofInstant(Instant.parse("2018-04-14T10:22:03Z"), ZoneId.systemDefault())
        date("20240316.wpilog", "2018-04-14 10:22:03 UTC").time shouldBe here
    }

    test("a date of a clock that nothing has set is passed over") {
        date("FRC_19700101_000012.bag", "1970-01-01T00:00:12") shouldBe LogDate.of(
            emptyList(),
            LogFile(
                Path.of("a"),
                1,
                written.atZone(ZoneId.systemDefault()).toInstant().toEpochMilli(),
            ),
        )
        date("99999999_999999.bag").source shouldBe DateSource.FILE_TIME
    }

    test("no text breaks it") {
        checkAll(Arb.string(0, 40)) { text -> date("a$text".replace('\u0000', 'x').replace('/', '-'), text) }
        val odd = listOf("1e300", "999999999999999999999", "-99999999999", "NaN123456789", "2024-02-30T00:00:00")
        for (text in odd) date("a", text)
    }
})
