package badlog.core.bag

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith

private fun bytes(text: String) = ByteArray(text.length) { text[it].code.toByte() }

private const val RLOG_START = "\u0001\u0000\u003f\u00ed\u0085\u00fa\u00eb\u00c4\u0008\u00d9\u0001\u0000\u0000\u0000\u0005/Time\u0002"

class ForeignFileSpec : FunSpec({
    listOf(
        "#ROSBAG V2.0\nE\u0000\u0000\u0000x\n1\n2\n" to "a ROS bag",
        "\u0089MCAP0\r\n\u0001" to "an MCAP log",
        "SQLite format 3\u0000\u0010" to "an SQLite database",
        "<!DOCTYPE html>\n<html><body>404 Not Found</body></html>" to "a web page",
        "\u00ef\u00bb\u00bf\n <HTML>" to "a web page in place of a log",
        "<?xml version=\"1.0\"?>\n<Error><Code>NoSuchKey</Code></Error>" to "an XML file",
        "PK\u0003\u0004\u0014\u0000\u0006\u0000\u0008\u0000Q12.wpilog" to "an archive",
        "PK\u0003\u0004\u0014\u0000\u0006\u0000[Content_Types].xml" to "a spreadsheet",
        "%PDF-1.7\n%\u00e2\u00e3" to "a PDF document",
        "\u0089PNG\r\n\u001a\n" to "a picture",
        "\u0000\u0000\u0000\u0020ftypisom" to "a video",
        "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n" to "a pointer of Git LFS",
        RLOG_START to "an RLOG",
        "RR\u0000\u0001\u0000\u0000" to "a log of Road Runner",
        "\u00fd7zXZ\u0000\u0000" to "compressed",
    ).forEach { (content, name) ->
        test("$name is reported in one sentence") {
            for (piece in listOf(1, 7, 4096)) {
                val recording = parse(bytes(content), piece)
                val refusal = recording.refusal.orEmpty()
                refusal shouldContain name
                refusal shouldEndWith "."
                recording.topics.size shouldBe 0
            }
        }
    }

    test("titles that resemble a foreign file's signature are titles") {
        for (title in listOf("PK,a", "RR,b", "SQLite,c", "<time>,d", "version,e", "#ROSBAG,f")) {
            parse("$title\n1,2\n3,4\n").topics.size shouldBe 2
        }
    }
})
