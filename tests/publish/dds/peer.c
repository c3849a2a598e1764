// Another process with Cyclone DDS, made of its own headers and types:
//   peer read DOMAIN TYPE=TOPIC...               prints messages until its standard input ends
//   peer agent DOMAIN OBSERVATION ACTION FILE    answers each observation with a row of FILE
//   peer nonsense DOMAIN OBSERVATION ACTION FILE the same, after what is not an action
#include <dds/dds.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "messages.h"

typedef sensor_msgs_msg_dds__JointState_ Joints;

#define NUMBER(T, FORMAT) \
  static void print_##T(const void* m) { printf(FORMAT, ((const std_msgs_msg_dds__##T##_*)m)->data_); }
#define ARRAY(T, FORMAT)                                                      \
  static void print_##T(const void* m) {                                      \
    const std_msgs_msg_dds__##T##_* a = m;                                    \
    for (uint32_t i = 0; i < a->layout_.dim_._length; ++i)                    \
      printf("%s%u/%u", i ? "x" : "", a->layout_.dim_._buffer[i].size_,       \
             a->layout_.dim_._buffer[i].stride_);                             \
    for (uint32_t i = 0; i < a->data_._length; ++i) printf(FORMAT, a->data_._buffer[i]); \
  }
NUMBER(Float32, "%.9g")
NUMBER(Int64, "%ld")
NUMBER(UInt32, "%u")
ARRAY(Float32MultiArray, " %.9g")
ARRAY(UInt8MultiArray, " %u")

static void print_header(const std_msgs_msg_dds__Header_* h) {
  printf("%d.%09u %s", h->stamp_.sec_, h->stamp_.nanosec_, h->frame_id_);
}
static void print_doubles(const char* name, const double* numbers, uint32_t count) {
  printf(" %s", name);
  for (uint32_t i = 0; i < count; ++i) printf(" %.9g", numbers[i]);
}
static void print_JointState(const void* m) {
  const Joints* j = m;
  print_header(&j->header_);
  for (uint32_t i = 0; i < j->name_._length; ++i) printf(" %s", j->name_._buffer[i]);
  print_doubles("position", j->position_._buffer, j->position_._length);
  print_doubles("velocity", j->velocity_._buffer, j->velocity_._length);
  print_doubles("effort", j->effort_._buffer, j->effort_._length);
}
static void print_Imu(const void* m) {
  const sensor_msgs_msg_dds__Imu_* i = m;
  print_header(&i->header_);
  print_doubles("orientation", i->orientation_covariance_, 1);
  print_doubles("linear", &i->linear_acceleration_.x_, 3);
  print_doubles("angular", &i->angular_velocity_.x_, 3);
}
static void print_Image(const void* m) {
  const sensor_msgs_msg_dds__Image_* i = m;
  print_header(&i->header_);
  printf(" %ux%u %s %u", i->height_, i->width_, i->encoding_, i->step_);
  for (uint32_t b = 0; b < i->data_._length; ++b) printf(" %u", i->data_._buffer[b]);
}
static void print_Clock(const void* m) {
  const rosgraph_msgs_msg_dds__Clock_* c = m;
  printf("%d.%09u", c->clock_.sec_, c->clock_.nanosec_);
}

static const struct Type {
  const char* name;
  const dds_topic_descriptor_t* type;
  void (*print)(const void*);
} types[] = {
#define STD(T) {#T, &std_msgs_msg_dds__##T##__desc, print_##T}
#define SENSOR(T) {#T, &sensor_msgs_msg_dds__##T##__desc, print_##T}
    STD(Float32),       STD(Int64),  STD(UInt32), STD(Float32MultiArray), STD(UInt8MultiArray),
    SENSOR(JointState), SENSOR(Imu), SENSOR(Image), {"Clock", &rosgraph_msgs_msg_dds__Clock__desc, print_Clock}};

static dds_entity_t checked(dds_entity_t e) {
  if (e >= 0) return e;
  fprintf(stderr, "peer: %s\n", dds_strretcode(e));
  exit(1);
}
/// `depth` 0: all.
static dds_qos_t* quality(int reliability, int durability, int depth) {
  dds_qos_t* q = dds_create_qos();
  dds_qset_reliability(q, reliability, DDS_SECS(1));
  dds_qset_history(q, depth > 0 ? DDS_HISTORY_KEEP_LAST : DDS_HISTORY_KEEP_ALL, depth);
  dds_qset_durability(q, durability);
  return q;
}
static int ended(void) {
  struct pollfd in = {0, POLLIN, 0};
  return poll(&in, 1, 1) > 0;
}

static int read_topics(dds_entity_t me, int count, char** topics) {
  dds_entity_t readers[256];
  const struct Type* of[256];
  const char* names[256];
  for (int t = 0; t < count; ++t) {
    const size_t length = strcspn(topics[t], "=");
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
      if (strlen(types[i].name) == length && strncmp(types[i].name, topics[t], length) == 0) of[t] = &types[i];
    names[t] = topics[t] + length + 1;
    const int is_event = strstr(names[t], "/reset") != NULL;
    dds_qos_t* q = quality(is_event ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                           is_event ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE, 0);
    readers[t] = checked(dds_create_reader(me, checked(dds_create_topic(me, of[t]->type, names[t], NULL, NULL)), q, NULL));
  }
  puts("ready");
  fflush(stdout);
  for (int last = 0, quiet = 0; !last || quiet < 50; ++quiet) {
    last = last || ended();
    if (last) dds_sleepfor(DDS_MSECS(2));
    for (int t = 0; t < count; ++t) {
      void* message[1] = {NULL};
      dds_sample_info_t info;
      while (dds_take(readers[t], message, &info, 1, 1) == 1) {
        quiet = 0;
        if (info.valid_data) {
          printf("%s ", names[t]);
          of[t]->print(message[0]);
          putchar('\n');
        }
        dds_return_loan(readers[t], message, 1);
        message[0] = NULL;
      }
    }
  }
  return 0;
}

static double rows[20000][16];
static int columns = 0;
static void read_rows(const char* path) {
  static char line[4096];
  FILE* file = fopen(path, "r");
  for (int row = 0; row < 20000 && file != NULL && fgets(line, sizeof line, file) != NULL; ++row) {
    columns = 0;
    for (char* at = strtok(line, ","); at != NULL; at = strtok(NULL, ",")) rows[row][columns++] = atof(at);
  }
}

static void answer(dds_entity_t writer, const Joints* to, double* numbers, uint32_t count, int32_t later_s) {
  Joints action;
  memset(&action, 0, sizeof action);
  action.header_ = to->header_;
  action.header_.stamp_.sec_ += later_s;
  action.position_._buffer = numbers;
  action.position_._length = action.position_._maximum = count;
  checked(dds_write(writer, &action));
}

/// Everything that is not an action, with the time of one.
static void write_nonsense(dds_entity_t writer, const Joints* to) {
  double wrong[16] = {0};
  answer(writer, to, wrong, columns + 1, 0);
  answer(writer, to, wrong, 0, 0);
  answer(writer, to, wrong, columns, 7);
  wrong[0] = NAN;
  answer(writer, to, wrong, columns, 0);
  wrong[0] = 1e30;
  answer(writer, to, wrong, columns, 0);
  wrong[0] = 1e300;
  answer(writer, to, wrong, columns, 0);
}

/// A writer that says it writes actions, and writes something else.
static void lie(dds_entity_t me, const char* topic, const dds_qos_t* q) {
  const dds_topic_descriptor_t* other = &std_msgs_msg_dds__Float32MultiArray__desc;
  const dds_topic_descriptor_t type = {.m_size = other->m_size,
                                       .m_align = other->m_align,
                                       .m_typename = sensor_msgs_msg_dds__JointState__desc.m_typename,
                                       .m_nops = other->m_nops,
                                       .m_ops = other->m_ops,
                                       .m_meta = ""};
  float numbers[64];
  memset(numbers, 0x7f, sizeof numbers);
  std_msgs_msg_dds__Float32MultiArray_ message;
  memset(&message, 0, sizeof message);
  message.data_._buffer = numbers;
  message.layout_.data_offset_ = 0x7fffffff;
  const dds_entity_t writer = checked(dds_create_writer(me, checked(dds_create_topic(me, &type, topic, NULL, NULL)), q, NULL));
  for (int i = 0; i < 50; ++i) {
    message.data_._length = message.data_._maximum = i;
    checked(dds_write(writer, &message));
    dds_sleepfor(DDS_MSECS(2));
  }
}

static int be_agent(dds_domainid_t domain, dds_entity_t me, char** arguments, int is_nonsense) {
  dds_qos_t* q = quality(DDS_RELIABILITY_RELIABLE, DDS_DURABILITY_VOLATILE, 0);
  const dds_topic_descriptor_t* type = &sensor_msgs_msg_dds__JointState__desc;
  read_rows(arguments[2]);
  const dds_entity_t other = checked(dds_create_participant(domain, NULL, NULL));
  const dds_entity_t third = checked(dds_create_participant(domain, NULL, NULL));
  if (is_nonsense)
    checked(dds_create_writer(
        third, checked(dds_create_topic(third, &std_msgs_msg_dds__Float64__desc, arguments[1], NULL, NULL)), q, NULL));
  const dds_entity_t writer =
      checked(dds_create_writer(me, checked(dds_create_topic(me, type, arguments[1], NULL, NULL)), q, NULL));
  const dds_entity_t reader =
      checked(dds_create_reader(me, checked(dds_create_topic(me, type, arguments[0], NULL, NULL)), q, NULL));
  const dds_entity_t waitset = checked(dds_create_waitset(me));
  checked(dds_waitset_attach(waitset, checked(dds_create_readcondition(reader, DDS_ANY_STATE)), 0));
  puts("ready");
  fflush(stdout);
  int answers = 0;
  while (!ended()) {
    void* message[1] = {NULL};
    dds_sample_info_t info;
    dds_waitset_wait(waitset, NULL, 0, DDS_MSECS(100));
    while (dds_take(reader, message, &info, 1, 1) == 1) {
      const Joints* seen = message[0];
      if (info.valid_data) {
        const int step = atoi(strchr(seen->header_.frame_id_, '/') + 1);
        if (is_nonsense) write_nonsense(writer, seen);
        if (is_nonsense && answers == 0) lie(other, arguments[1], q);
        answer(writer, seen, rows[step], columns, 0);
        if (answers++ == 0) puts("answered");
        fflush(stdout);
      }
      dds_return_loan(reader, message, 1);
      message[0] = NULL;
      dds_waitset_wait(waitset, NULL, 0, DDS_MSECS(100));
    }
  }
  return 0;
}

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const dds_domainid_t domain = (dds_domainid_t)atoi(arguments[2]);
  const dds_entity_t me = checked(dds_create_participant(domain, NULL, NULL));
  if (strcmp(arguments[1], "read") == 0) return read_topics(me, count - 3, arguments + 3);
  return be_agent(domain, me, arguments + 3, strcmp(arguments[1], "nonsense") == 0);
}
