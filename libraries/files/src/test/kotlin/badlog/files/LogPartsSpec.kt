package badlog.files

import badlog.core.recording.RecordingFormat
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.driverstation.STATION_LOG
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class LogPartsSpec : FunSpec({
    test("a Driver Station log is read, and tells its start by its first bytes; what is another log, has no samples or is gone is none") {
        inFolder { folder ->
            Files.write(folder.resolve("a.dslog"), STATION_LOG.bytes)
            Files.write(folder.resolve("head.dslog"), STATION_LOG.bytes.copyOf(DriverStationFormat.HEAD_SIZE))
            Files.writeString(folder.resolve("rows.dslog"), "Time (s),A\n0,1\n1,2\n")
            val logs = stationLogsIn(folder).associateBy { it.name }
            logs.keys shouldBe setOf("a.dslog", "head.dslog", "rows.dslog")
            readStationLog(logs.getValue("a.dslog"), LOG_FORMATS)?.format shouldBe RecordingFormat.DRIVER_STATION
            readStationLog(logs.getValue("head.dslog"), LOG_FORMATS).shouldBeNull()
            readStationLog(logs.getValue("rows.dslog"), LOG_FORMATS).shouldBeNull()
            fun startOf(name: String) = startOfStationLog(logs.getValue(name), DriverStationFormat.HEAD_SIZE, DriverStationFormat::startOf)
            startOf("a.dslog") shouldBe startOf("head.dslog")
            // 2026-03-07 15:04:05.5 UTC.
            startOf("a.dslog") shouldBe 1_772_895_845.5
            startOf("rows.dslog").shouldBeNull()
            Files.delete(folder.resolve("a.dslog"))
            readStationLog(logs.getValue("a.dslog"), LOG_FORMATS).shouldBeNull()
            startOf("a.dslog").shouldBeNull()
        }
    }
})
