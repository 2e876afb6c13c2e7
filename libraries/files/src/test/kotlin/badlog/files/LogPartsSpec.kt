package badlog.files

import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.driverstation.STATION_LOG
import badlog.formats.driverstation.isOfDriverStation
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import java.nio.file.Files
import java.nio.file.Path

class LogPartsSpec : FunSpec({
    test("a Driver Station log is recognized by its first bytes, which have its start; other, empty and missing files are not") {
        inFolder { folder ->
            Files.write(folder.resolve("a.dslog"), STATION_LOG.bytes)
            Files.write(folder.resolve("head.dslog"), STATION_LOG.bytes.copyOf(DriverStationFormat.HEAD_SIZE))
            Files.writeString(folder.resolve("rows.dslog"), "Time (s),A\n0,1\n1,2\n")
            val logs = stationLogsIn(folder).associateBy { it.name }
            logs.keys shouldBe setOf("a.dslog", "head.dslog", "rows.dslog")
            readStationLog(logs.getValue("a.dslog"), LOG_FORMATS)?.format shouldBe DriverStationFormat
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

    test("from 2027 on, a WPILOG is of the Driver Station if nothing else is in it, and is found by its name") {
        fun wpilog(vararg names: String) = wpilogWith(names.toList())
        inFolder { folder ->
            Files.write(folder.resolve("FIRST_DS_20270306_150000.wpilog"), wpilog("DS:/Dscomm/Status/Power/Battery", "systemTime", "DS:/.schema/proto:mrc.proto"))
            Files.write(folder.resolve("first_ds_of_a_robot.wpilog"), wpilog("DS:/Dscomm/Status/Power/Battery", "NT:/Arm/Angle"))
            Files.write(folder.resolve("WPILIB_20270306_150000.wpilog"), wpilog("DS:controlWord"))
            val logs = stationLogsIn(folder).associateBy { it.name }
            logs.keys shouldBe setOf("FIRST_DS_20270306_150000.wpilog", "first_ds_of_a_robot.wpilog")
            readStationLog(logs.getValue("FIRST_DS_20270306_150000.wpilog"), LOG_FORMATS)?.isOfDriverStation shouldBe true
            readStationLog(logs.getValue("first_ds_of_a_robot.wpilog"), LOG_FORMATS).shouldBeNull()
            readRecording(folder.resolve("WPILIB_20270306_150000.wpilog"), LOG_FORMATS).isOfDriverStation shouldBe false
        }
    }

    test("the Driver Station's logs are searched for in each season's folders, on each system") {
        val user = Path.of("/home/pit")
        stationFolders(user) { null } shouldBe listOf(user.resolve(".firstds"))
        stationFolders(user) { if (it == "PUBLIC") "/Users/Public" else null } shouldBe listOf(
            Path.of("/Users/Public/Documents/FRC/Log Files/DSLogs"),
            Path.of("/Users/Public/Documents/FIRSTDriverStation/Logs"),
            Path.of("/Users/Public/Documents/firstds"),
            user.resolve(".firstds"),
        )
    }
})

/** A WPILOG with a number in each of the entries [names]. */
private fun wpilogWith(names: List<String>): ByteArray {
    fun number(value: Long, size: Int) = ByteArray(size) { (value ushr 8 * it).toByte() }
    fun text(text: String) = number(text.length.toLong(), 4) + text.encodeToByteArray()
    fun record(id: Int, payload: ByteArray) = byteArrayOf(0x7F) + number(id.toLong(), 4) + number(payload.size.toLong(), 4) + number(1_000_000, 8) + payload
    val head = "WPILOG".encodeToByteArray() + byteArrayOf(0, 1, 0, 0, 0, 0)
    return names.foldIndexed(head) { index, bytes, name ->
        val start = byteArrayOf(0) + number(index + 1L, 4) + text(name) + text("double") + text("")
        bytes + record(0, start) + record(index + 1, number(12.0.toRawBits(), 8))
    }
}
