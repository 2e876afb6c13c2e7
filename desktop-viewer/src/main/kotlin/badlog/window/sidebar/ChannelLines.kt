package badlog.window.sidebar

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.shown.statistics.ChannelOrder
import badlog.viewer.shown.statistics.RankedChannel
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton

/** The heading above the channels of the power distribution, or the motors, with buttons for their order. [what] is their kind. */
@Composable
internal fun ChannelsHead(what: String, panels: WindowPanels) =
    Row(Modifier.padding(start = 12.dp, top = 14.dp), Arrangement.spacedBy(4.dp), Alignment.CenterVertically) {
        Text("${what}s by", fontWeight = FontWeight.SemiBold)
        for (order in ChannelOrder.entries) {
            ToolButton(order.hint, text = order.title, isOn = panels.state.channels == order) { panels.change { copy(channels = order) } }
        }
    }

/** The charge, share and peak of [channel], above a bar of its value by [order]. A bar of the value [most] takes the full width. */
@Composable
internal fun ChannelLine(channel: RankedChannel, most: Double, order: ChannelOrder) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 4.dp)) {
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
            Tip(channel.topic, Modifier.weight(1f)) {
                NameText(channel.name, fontSize = 12.sp)
            }
            Text(
                "${channel.chargeText}, ${channel.shareText}, up to ${channel.peakText}",
                color = palette.muted,
                fontSize = 12.sp,
                maxLines = 1,
            )
        }
        Box(
            Modifier
                .fillMaxWidth(if (most > 0) (channel.by(order) / most).toFloat().coerceIn(0f, 1f) else 0f)
                .height(3.dp)
                .background(palette.accent, RoundedCornerShape(2.dp)),
        )
    }
}
