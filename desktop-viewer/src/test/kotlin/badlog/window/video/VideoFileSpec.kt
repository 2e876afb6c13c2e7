package badlog.window.video

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import org.bytedeco.ffmpeg.global.avcodec.AV_CODEC_ID_HEVC
import org.bytedeco.ffmpeg.global.avcodec.avcodec_find_decoder
import java.nio.file.Files
import kotlin.random.Random

class VideoFileSpec : FunSpec({
    val folder = tempdir().toPath()
    val video = CountedVideo.write(folder.resolve("Spiel ä.mp4"))
    val last = CountedVideo.FRAMES - 1

    fun timeOf(number: Int) = number.toDouble() / CountedVideo.FRAMES_PER_SECOND

    fun VideoFile.number() = picture().use { CountedVideo.numberIn(it.image) }

    fun VideoFile.shouldShow(number: Int) = withClue("frame $number") {
        number() shouldBe number
        time shouldBe (timeOf(number) plusOrMinus 1e-4)
    }

    test("every frame is shown one after the other, each at its time, and backwards again") {
        VideoFile(video).use { file ->
            file.duration shouldBe (timeOf(CountedVideo.FRAMES) plusOrMinus 0.05)
            for (number in 0..last) {
                file.shouldShow(number)
                file.next() shouldBe (number < last)
            }
            for (number in last - 1 downTo last - 90) {
                file.previous() shouldBe true
                file.shouldShow(number)
            }
        }
    }

    test("a seek shows the frame of that moment, wherever the video was before") {
        val random = Random(2026)
        VideoFile(video).use { file ->
            repeat(150) {
                val number = random.nextInt(CountedVideo.FRAMES)
                file.seek(timeOf(number) + random.nextDouble(0.0, 0.9 / CountedVideo.FRAMES_PER_SECOND))
                file.shouldShow(number)
            }
        }
    }

    test("a frame is found at its start, rounded like alignments") {
        VideoFile(video).use { file ->
            for (number in listOf(1, 7, 76, 151, 100)) {
                file.seek(Math.round(timeOf(number) * 10_000) / 10_000.0)
                file.shouldShow(number)
            }
        }
    }

    test("a video shows its first frame before its start, and its last one beyond its end") {
        VideoFile(video).use { file ->
            file.seek(1000.0)
            file.shouldShow(last)
            file.next() shouldBe false
            file.seek(-1000.0)
            file.shouldShow(0)
            file.previous() shouldBe false
            file.shouldShow(0)
        }
    }

    test("a file that was cut off shows the remaining frames") {
        val whole = Files.readAllBytes(CountedVideo.write(folder.resolve("whole.mkv")))
        val cut = Files.write(folder.resolve("cut.mkv"), whole.copyOf(whole.size / 2))
        VideoFile(cut).use { file ->
            file.shouldShow(0)
            file.seek(1000.0)
            (file.number() in 60..<last) shouldBe true
            file.seek(timeOf(40))
            file.number() shouldBe 40
        }
    }

    test("a phone's video that is stored on its side is shown upright") {
        VideoFile(CountedVideo.write(folder.resolve("upright.mp4"), turnedBy = 90)).use { file ->
            file.seek(timeOf(203))
            file.picture().use { frame ->
                (frame.image.width to frame.image.height) shouldBe (136 to 240)
                CountedVideo.numberInTurned(frame.image) shouldBe 203
            }
        }
    }

    test("the HEVC videos of phones are decoded") {
        avcodec_find_decoder(AV_CODEC_ID_HEVC).name().string shouldBe "hevc"
    }

    test("one sentence reports a file that is missing, or not a video") {
        val noise = Files.write(folder.resolve("noise.mp4"), Random(1).nextBytes(100_000))
        val empty = Files.write(folder.resolve("empty.mov"), ByteArray(0))
        for (file in listOf(noise, empty)) {
            shouldThrow<VideoException> { VideoFile(file) }.message shouldBe
                "${file.fileName} cannot be shown: it is not a video, or it is damaged."
        }
        shouldThrow<VideoException> { VideoFile(folder.resolve("gone.mp4")) }.message shouldBe
            "gone.mp4 cannot be read; check that it is still there."
    }
})
